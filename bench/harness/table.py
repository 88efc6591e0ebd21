"""A CSV file that a run adds rows to, and from which an interrupted run goes on."""
import csv
import io
import os


class Table:
    """Rows are dictionaries of text. A row is known by its key; the last row of a key counts."""

    def __init__(self, path, key, columns, retry=False):
        """With `retry`, rows that are there but failed do not count as finished."""
        self.path, self.key, self.columns = path, tuple(key), list(columns)
        self.retry = retry
        self.rows = {}
        if os.path.exists(path):
            self._read()

    def _read(self):
        with open(self.path, newline="", encoding="utf-8") as file:
            text = file.read()
        whole = text[:text.rfind("\n") + 1]  # without the line that an interruption cut off
        reader = csv.DictReader(io.StringIO(whole, newline=""))
        for row in reader:
            self.rows[self._key(row)] = {c: row.get(c) or "" for c in self.columns}
        if whole != text or reader.fieldnames != self.columns:
            self._rewrite()

    def _rewrite(self):
        temporary = self.path + ".new"
        with open(temporary, "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, self.columns, lineterminator="\n")
            writer.writeheader()
            writer.writerows(self.rows.values())
        os.replace(temporary, self.path)

    def _key(self, row):
        return tuple(str(row[k]) for k in self.key)

    def is_finished(self, *key):
        row = self.rows.get(tuple(str(k) for k in key))
        return row is not None and not (self.retry and row["status"] != "ok")

    def __contains__(self, key):
        return tuple(str(k) for k in key) in self.rows

    def __getitem__(self, key):
        return self.rows[tuple(str(k) for k in key)]

    def add(self, row):
        """Appends at once, so that whatever is finished stays."""
        text = {c: format_value(row.get(c)) for c in self.columns}
        self.rows[self._key(text)] = text
        new = not os.path.exists(self.path)
        os.makedirs(os.path.dirname(self.path) or ".", exist_ok=True)
        with open(self.path, "a", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, self.columns, lineterminator="\n")
            if new:
                writer.writeheader()
            writer.writerow(text)
        return text


def format_value(value):
    if value is None:
        return ""
    if isinstance(value, bool):
        return "1" if value else "0"
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def number(text):
    """The number in a cell, or None."""
    try:
        return float(text)
    except (TypeError, ValueError):
        return None
