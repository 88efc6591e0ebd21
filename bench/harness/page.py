"""The page: one HTML file that needs nothing beside it."""
from html import escape

from harness import paper, plot, speed, summary
from harness.table import number

STYLE = """
body{font:15px/1.45 system-ui,sans-serif;margin:2em auto;max-width:1180px;padding:0 1em;color:#1c2430}
h1,h2,h3{line-height:1.2}h2{margin-top:2em;border-bottom:1px solid #ccd3dc}
table{border-collapse:collapse;margin:.6em 0;font-size:13px;display:block;overflow-x:auto}
th,td{padding:3px 9px;border-bottom:1px solid #e2e7ee;text-align:right;white-space:nowrap}
th:first-child,td:first-child{text-align:left}th{background:#f2f5f9}
.note{color:#55606e;font-size:13px;max-width:60em}
figure{display:inline-block;margin:4px;text-align:center;font-size:12px;color:#55606e}
figure img{display:block;margin:auto;border:1px solid #e2e7ee}
summary{cursor:pointer;padding:2px 0}svg text{font-size:11px;fill:#55606e}.grid{stroke:#dde3ea}
"""


def figure(uri, caption):
    return f'<figure><img alt="{escape(caption)}" src="{uri}">{escape(caption)}</figure>'


def pictures_of(pictures, names):
    """names: (folder, file) -> caption. Those that were not drawn are left out."""
    found = ((pictures.data_uri(*name), caption) for name, caption in names.items())
    return "".join(figure(uri, caption) for uri, caption in found if uri)


def heading(facts):
    rows = "".join(f"<tr><td>{escape(k)}</td><td style='text-align:left'>{escape(v)}</td></tr>"
                   for k, v in facts.items())
    return f"<h1>arris: benchmark</h1><table><tbody>{rows}</tbody></table>"


def methods_section(methods, missing):
    rows = "".join(
        f"<tr><td>{escape(m.title)}</td><td style='text-align:left'>{escape(m.version)}</td>"
        f"<td style='text-align:left;white-space:normal'>{escape(m.settings)}</td></tr>"
        for m in methods)
    absent = (f"<p>Not found on this machine: {escape(', '.join(missing))}; "
              "scripts/install-peers.sh installs them.</p>" if missing else "")
    return ("<h2>Methods</h2><p>Every method gets the same file of positions, in a process of its "
            "own, with one thread and a limit of time and memory. Nothing is trimmed, closed or "
            "repaired afterwards. Normals are compared without orientation, so a mesh that is "
            "inside out loses nothing.</p><table><thead><tr><th>method</th><th>version</th>"
            f"<th>settings</th></tr></thead><tbody>{rows}</tbody></table>{absent}")


def paper_section(suite, pictures):
    if not suite.table.rows:
        return ""
    parts = ["<h2>The paper</h2><p>Shi, Wan, Tai and Wang, Curvature Minimization for Surface "
             "Reconstruction with Features (SSVM 2011). Models are made after its figures, with "
             "samples on corners and edges.</p><h3>Table 1</h3>",
             summary.table_1(suite.table, suite.version).html(),
             "<h3>Figure 6: curvature against total variation</h3>"]
    captions = {("paper", f"{paper.FIGURE_6_EXAMPLE}-{s}"): title
                for s, (title, _) in paper.FIGURE_6.items()}
    parts += [pictures_of(pictures, captions), summary.figure_6(suite.table, suite.version).html()]
    for title, examples in paper.FIGURES.items():
        rows = ["".join(pictures_of(pictures, {("paper", f"{e}-{kind}"): caption})
                        for e in examples)
                for kind, caption in (("input", "samples"), ("paper", "--method paper"),
                                      ("default", "default"))]
        parts.append(f"<h3>{escape(title)}</h3>" + "".join(f"<div>{r}</div>" for r in rows))
        parts.append(summary.examples_grid(suite.table, suite.version, examples).html())
    return "".join(parts)


def quality_section(title, suite, variants, pictures):
    rows_of = summary.current(suite.table, suite.methods)
    if not any(rows_of.values()):
        return ""
    parts = [f"<h2>{escape(title)}</h2><p>Median over the cases that gave a mesh, and the worst in "
             "brackets. Meshes: how many runs gave one; sound: closed, manifold and free of "
             "self-intersections; right topology: closed, manifold, and components and Euler "
             "characteristic of the truth. The last two count every run, failed ones too. Lengths are shares of the "
             "diagonal.</p>"]
    for variant in variants:
        grid = summary.quality_grid(rows_of, suite.methods, variant)
        if grid.rows:
            parts.append(f"<h3>{escape(variant)}</h3>{grid.html()}")
    failures = summary.failures_grid(rows_of, suite.methods)
    if failures.rows:
        parts.append(f"<details><summary>{len(failures.rows)} failures, with the reason</summary>"
                     f"{failures.html()}</details>")
    parts.append("<h3>Every case</h3>")
    parts += [case_details(rows_of, suite, case, pictures) for case in suite.cases]
    for name, reason in sorted(set(suite.skipped)):
        parts.append(f"<p>No input for {escape(name)}: {escape(reason)}</p>")
    return "".join(parts)


def case_details(rows_of, suite, case, pictures):
    grid = summary.case_grid(rows_of, suite.methods, case.name)
    if not grid.rows:
        return ""
    names = {(case.name, "input"): "points", (case.name, "truth"): "truth"}
    names.update({(case.name, m.name): m.title for m in suite.methods if m.ours})
    names[(case.name, "error")] = "errors of arris, up to 0.5 %"
    names.update({(case.name, m.name): m.title for m in suite.methods if not m.ours})
    return (f"<details><summary>{escape(case.name)}</summary>{pictures_of(pictures, names)}"
            f"{grid.html()}</details>")


def speed_section(suite, version, machine):
    sizes = summary.speed_rows(suite.table, "arris", version)
    if not sizes:
        return ""
    series = {"seconds": {}, "peak_mb": {}}
    for column, lines in series.items():
        lines["arris"] = [(n, number(rows[speed.WHOLE][column])) for n, rows in sizes.items()]
        for m in suite.methods:
            peer = summary.speed_rows(suite.table, m.name, m.version)
            lines[m.title] = [(n, number(rows[speed.WHOLE][column])) for n, rows in peer.items()]
    series["seconds"]["CGAL Delaunay alone"] = [
        (n, number(rows[speed.WHOLE]["cgal_delaunay_s"])) for n, rows in sizes.items()]
    return ("<h2>Speed</h2><p>Random samples of a bumpy sphere in random order, on "
            f"{escape(machine)}. arris uses all threads here; peers, with reading and writing, "
            "one.</p>"
            + summary.speed_grid(suite.table, version).html()
            + summary.stage_memory_grid(suite.table, version).html()
            + plot.log_log(series["seconds"], "points", "seconds")
            + plot.log_log(series["peak_mb"], "points", "peak memory, MB"))


def write(path, sections):
    with open(path, "w", encoding="utf-8") as file:
        file.write("<!doctype html><html lang=en><meta charset=utf-8><title>arris: benchmark</title>"
                   f"<meta name=viewport content='width=device-width'><style>{STYLE}</style><body>")
        file.writelines(sections)
        file.write("</body></html>\n")
