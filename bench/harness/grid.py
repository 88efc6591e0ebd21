"""Tables to read: a header and rows of text, as HTML or as Markdown."""
from dataclasses import dataclass, field
from html import escape


@dataclass
class Grid:
    header: list
    rows: list = field(default_factory=list)
    note: str = ""

    def html(self):
        head = "".join(f"<th>{escape(h)}</th>" for h in self.header)
        body = "".join("<tr>" + "".join(f"<td>{escape(str(c))}</td>" for c in row) + "</tr>"
                       for row in self.rows)
        note = f"<p class=note>{escape(self.note)}</p>" if self.note else ""
        return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>{note}"

    def markdown(self):
        lines = ["| " + " | ".join(str(c).replace("|", "\\|") for c in row) + " |"
                 for row in [self.header, ["---"] * len(self.header), *self.rows]]
        return "\n".join(lines) + ("\n\n" + self.note if self.note else "") + "\n"


def fixed(value, digits):
    return "–" if value is None else f"{value:.{digits}f}"


def scaled(factor, digits):
    """A format for a number that is shown in units of 1 / factor."""
    return lambda value: fixed(None if value is None else factor * value, digits)
