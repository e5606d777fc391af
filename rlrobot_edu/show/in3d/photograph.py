"""A picture of a page, made by Chromium without a window."""

import shutil
import subprocess
import tempfile
from pathlib import Path

EXECUTABLES = ("chromium", "chromium-browser", "google-chrome", "chrome")
OPTIONS = (
    "--headless",
    "--no-sandbox",  # root, in a container, has none; the page is our own
    "--hide-scrollbars",
    "--use-angle=swiftshader",  # WebGL without a graphics card
    "--enable-unsafe-swiftshader",
    "--window-size=585,378",
    "--force-device-scale-factor=2",
    "--force-prefers-reduced-motion",
)


def photograph(page: str) -> bytes:
    """A PNG of an HTML page, 585 by 378 pixels of the page in double resolution.

    Raises RuntimeError if Chromium is not installed, or if it makes no picture.
    """
    found = [shutil.which(name) for name in EXECUTABLES]
    installed = [path for path in found if path is not None]
    if not installed:
        raise RuntimeError(
            "a picture in 3D is made by Chromium, which is not installed: install chromium"
        )
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "page.html")
        picture = Path(folder, "page.png")
        file.write_text(page, encoding="utf-8")
        command = [
            installed[0],
            *OPTIONS,
            f"--user-data-dir={folder}/profile",
            f"--screenshot={picture}",
            f"{file.as_uri()}#still",  # a page that moves stands still at its end
        ]
        try:
            subprocess.run(command, capture_output=True, timeout=120, check=True)
        except subprocess.SubprocessError as error:
            raise RuntimeError(f"Chromium made no picture: {error}") from error
        if not picture.is_file():
            raise RuntimeError("Chromium made no picture, and did not say why")
        return picture.read_bytes()
