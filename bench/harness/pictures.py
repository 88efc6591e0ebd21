"""Small pictures of clouds, meshes and errors, one file each, drawn by `arris render`."""
import base64
import os

from harness import process, thumbnail

LIMITS = process.Limits(seconds=120)
AZIMUTH = ("--azimuth", "40")
ERROR_SIZE = "240x190"  # of each of the two meshes, so that their captions fit
VIEW = ("--size", "132x116", "--samples", "2", "--occlusion", "0", *AZIMUTH)
LARGE_VIEW = ("--size", "220x200", "--samples", "2", "--occlusion", "16", *AZIMUTH)


def shrink(path):
    with open(path, "rb") as file:
        data = thumbnail.small(file.read())
    with open(path, "wb") as file:
        file.write(data)


class Pictures:
    """Draws what is not drawn yet. A picture that cannot be drawn is left out."""

    def __init__(self, arris, folder):
        self.arris, self.folder = arris, folder

    def path(self, *parts):
        return os.path.join(self.folder, *parts) + ".png"

    def draw(self, name, files, view=VIEW, options=()):
        """`name` is a tuple of folder and file name."""
        path = self.path(*name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        self.remove(name)
        outcome = process.run([self.arris, "render", *files, "-o", path, "--quiet",
                               "--threads", "1", *view, *options], LIMITS)
        if outcome.ok:
            shrink(path)

    def remove(self, name):
        if os.path.exists(self.path(*name)):
            os.remove(self.path(*name))

    def error_options(self, name):
        """Options of `arris compare` that draw the errors of both meshes."""
        path = self.path(*name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        return ("--picture", path, "--size", ERROR_SIZE, *AZIMUTH)

    def shrink(self, name):
        if os.path.exists(self.path(*name)):
            shrink(self.path(*name))

    def data_uri(self, *name):
        """The picture for a page, or None if there is none."""
        try:
            with open(self.path(*name), "rb") as file:
                return "data:image/png;base64," + base64.b64encode(file.read()).decode("ascii")
        except OSError:
            return None
