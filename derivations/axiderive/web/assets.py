"""Files every page loads: KaTeX with its fonts in the style sheet, the sheet and the script of the site."""

from __future__ import annotations

import base64
import re
from importlib.resources import files

_FACE = re.compile(r"@font-face\{[^}]*url\(fonts/([\w-]+\.woff2)\)[^}]*\}")
_SOURCE = re.compile(r"src:[^}]*")


def assets() -> dict[str, str]:
    """Text by path below the folder of the web edition."""
    folder = files("axiderive.web")
    vendored, own = folder / "katex", folder / "static"
    return {
        "assets/katex.js": (vendored / "katex.min.js").read_text(encoding="utf-8"),
        "assets/katex.css": _with_fonts((vendored / "katex.min.css").read_text(encoding="utf-8")),
        "assets/katex-license.txt": (vendored / "LICENSE").read_text(encoding="utf-8"),
        "assets/site.css": (own / "site.css").read_text(encoding="utf-8"),
        "assets/site.js": (own / "site.js").read_text(encoding="utf-8"),
    }


def _with_fonts(css: str) -> str:
    """The style sheet with its fonts inside, so that a page opened from a folder needs no second origin.

    Faces that no formula of the book uses are not vendored and left out.
    """

    def face(match: re.Match[str]) -> str:
        font = files("axiderive.web") / "katex" / "fonts" / match[1]
        if not font.is_file():
            return ""
        data = base64.b64encode(font.read_bytes()).decode()
        return _SOURCE.sub(f'src:url(data:font/woff2;base64,{data}) format("woff2")', match[0])

    return _FACE.sub(face, css)
