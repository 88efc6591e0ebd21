"""Tests of the benchmark's harness: python3 -m unittest, from this directory or by ctest."""
import os
import struct
import sys
import tempfile
import unittest
import zlib

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench"))
from harness import grid, metrics, plot, process, summary, thumbnail  # noqa: E402
from harness.table import Table  # noqa: E402


def python(code):
    return [sys.executable, "-c", code]


class Process(unittest.TestCase):
    def test_success_has_output_and_peak(self):
        outcome = process.run(python("b = bytearray(64 << 20); print('done')"))
        self.assertEqual((outcome.status, outcome.output), ("ok", "done\n"))
        self.assertGreater(outcome.memory, 64 << 20)

    def test_failure_has_the_last_line_as_reason(self):
        outcome = process.run(python("import sys; sys.exit('first\\nthe reason')"))
        self.assertEqual((outcome.status, outcome.reason), ("failed", "the reason"))
        self.assertEqual(process.run(python("import os; os.abort()")).reason, "ended by SIGABRT")
        remedy = "import sys; sys.exit('arris: no such file\\n  remedy: check the path')"
        self.assertEqual(process.run(python(remedy)).reason, "arris: no such file")
        self.assertEqual(process.run(["/no/such/program"]).status, "failed")

    def test_time_ends_it_and_its_children(self):
        code = "import subprocess; subprocess.run(['sleep', '60'])"
        outcome = process.run(python(code), process.Limits(seconds=0.5))
        self.assertEqual(outcome.status, "timeout")
        self.assertLess(outcome.seconds, 10)

    def test_memory_ends_it(self):
        code = "import time; b = bytearray(256 << 20); time.sleep(60)"
        outcome = process.run(python(code), process.Limits(seconds=50, memory=128 << 20))
        self.assertEqual(outcome.status, "memory")


class Tables(unittest.TestCase):
    def test_an_interrupted_line_is_dropped_and_the_rest_stays(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "rows.csv")
            table = Table(path, ("case", "method"), ("case", "method", "value", "right"))
            table.add({"case": "a", "method": "x", "value": 0.125, "right": True})
            table.add({"case": "b", "method": "x", "value": None, "right": False})
            with open(path, "a", encoding="utf-8") as file:
                file.write("c,x,2,")
            again = Table(path, ("case", "method"), ("case", "method", "value", "right"))
            self.assertEqual(list(again.rows), [("a", "x"), ("b", "x")])
            self.assertEqual(again["a", "x"]["value"], "0.125")
            self.assertIn(("b", "x"), again)
            again.add({"case": "c", "method": "x", "value": 2, "right": True})
            third = Table(path, ("case", "method"), ("case", "method", "value", "right"))
            self.assertEqual(len(third.rows), 3)

    def test_failures_are_finished_unless_they_are_tried_again(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "rows.csv")
            table = Table(path, ("case",), ("case", "status"))
            table.add({"case": "a", "status": "ok"})
            table.add({"case": "b", "status": "timeout"})
            self.assertTrue(table.is_finished("a") and table.is_finished("b"))
            self.assertFalse(table.is_finished("c"))
            again = Table(path, ("case",), ("case", "status"), retry=True)
            self.assertTrue(again.is_finished("a"))
            self.assertFalse(again.is_finished("b"))

    def test_the_last_row_of_a_key_counts(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "rows.csv")
            for value in (1, 2):
                Table(path, ("case",), ("case", "value")).add({"case": "a", "value": value})
            self.assertEqual(Table(path, ("case",), ("case", "value"))["a",]["value"], "2")


def true_colour_png(width, height, pixel, kind):
    """A PNG whose rows all have the filter `kind` (0, none; 1, left; 2, above)."""
    rows, above = [], bytes(3 * width)
    for y in range(height):
        row = bytes(v for x in range(width) for v in pixel(x, y))
        left = bytes(3) + row[:-3]
        guess = {0: bytes(3 * width), 1: left, 2: above}[kind]
        rows.append(bytes([kind]) + bytes((a - b) & 255 for a, b in zip(row, guess)))
        above = row
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (thumbnail.SIGNATURE + thumbnail.chunk(b"IHDR", header)
            + thumbnail.chunk(b"IDAT", zlib.compress(b"".join(rows)))
            + thumbnail.chunk(b"IEND", b""))


class Thumbnails(unittest.TestCase):
    def test_colours_stay_within_rounding(self):
        def pixel(x, y):
            return (x * 20 % 256, y * 30 % 256, 255 if x == y else 0)
        for kind in (0, 1, 2):
            parts = dict(thumbnail.chunks(thumbnail.small(true_colour_png(13, 9, pixel, kind))))
            rows, palette = zlib.decompress(parts[b"IDAT"]), parts[b"PLTE"]
            for y in range(9):
                for x in range(13):
                    index = rows[y * 14 + 1 + x]
                    for got, true in zip(palette[3 * index:3 * index + 3], pixel(x, y)):
                        self.assertLessEqual(abs(got - true), 8)

    def test_what_is_no_png_is_left_alone(self):
        self.assertEqual(thumbnail.small(b"GIF89a"), b"GIF89a")


class Reading(unittest.TestCase):
    def test_a_report_without_a_figure_is_refused(self):
        with self.assertRaises(KeyError):
            metrics.figures_of({"chamfer": 1})

    def test_median_and_worst(self):
        rows = [{"v": "1"}, {"v": "5"}, {"v": ""}, {"v": "2"}]
        text = grid.scaled(1, 0)
        self.assertEqual(summary.median_and_worst(rows, "v", text, False), "2 (5)")
        self.assertEqual(summary.median_and_worst(rows, "v", text, True), "2 (1)")
        self.assertEqual(summary.median_and_worst([{"v": ""}], "v", text, True), "–")

    def test_tables_escape_what_they_show(self):
        shown = grid.Grid(["<a>"], [["x|y"]])
        self.assertIn("&lt;a&gt;", shown.html())
        self.assertIn("x\\|y", shown.markdown())

    def test_a_plot_places_powers_of_ten_on_its_grid(self):
        axes = plot.Axes([10, 1000], [1, 10])
        self.assertAlmostEqual(axes.at_x(100), (axes.at_x(10) + axes.at_x(1000)) / 2)
        self.assertEqual(plot.log_log({"a": []}, "x", "y"), "")


if __name__ == "__main__":
    unittest.main()
