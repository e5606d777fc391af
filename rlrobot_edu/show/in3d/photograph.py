"""A page as a browser shows it, by a Chromium without a window."""

import shutil
import subprocess
import tempfile
from pathlib import Path

NAMES = ("chromium", "chromium-browser", "google-chrome", "chrome")
OPTIONS = ("--headless", "--no-sandbox", "--hide-scrollbars", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
           "--window-size=585,378",
           "--force-device-scale-factor=2", "--force-prefers-reduced-motion")  # fmt: skip


def photograph(page: str) -> bytes:
    """A PNG of an HTML page, 585 by 378 pixels of a page, twice as fine.

    Raises RuntimeError where there is no Chromium, or where it makes no picture.
    """
    chromium = next(filter(None, map(shutil.which, NAMES)), None)
    if chromium is None:
        raise RuntimeError(
            "a picture in 3D is made by Chromium, and there is none here: install chromium"
        )
    with tempfile.TemporaryDirectory() as folder:
        file, picture = Path(folder, "page.html"), Path(folder, "page.png")
        file.write_text(page, encoding="utf-8")
        command = [
            chromium,
            *OPTIONS,
            f"--user-data-dir={folder}/profile",
            f"--screenshot={picture}",
        ]
        try:
            subprocess.run(
                [*command, file.as_uri() + "#still"],
                capture_output=True,
                timeout=120,
                check=True,
            )
        except subprocess.SubprocessError as error:
            raise RuntimeError(f"Chromium made no picture: {error}") from error
        return picture.read_bytes()
