"""Settings of Sphinx for the documentation site. `make docs` begins with make_site.py, which calls it."""

import os
import re
from html import escape, unescape
from pathlib import Path
from textwrap import shorten
from typing import Any

from docutils import nodes
from latex2mathml.converter import convert
from sphinx.application import Sphinx
from sphinx.writers.html5 import HTML5Translator

import rlrobot_edu as rl

project = "RLROBOT-EDU"
author = copyright = "the RLROBOT-EDU developers"
version = release = rl.__version__

extensions = [
    "myst_nb",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx.ext.githubpages",
]
root_doc = "docs/index"
html_theme = "furo"
html_favicon = "site/favicon.svg"
html_title = "RLROBOT-EDU"
html_copy_source = html_show_sourcelink = False
html_static_path = [
    "site/site.css",
    "site/site.js",
    "../rlrobot_edu/widgets/playground/host_page.js",
]
html_css_files = ["site.css"]
html_js_files = ["host_page.js", "site.js"]

html_math_renderer = (
    "mathml"  # browsers draw it without a program and without a font of ours
)
html_show_search_summary = False  # excerpts would load whole pages, 4 MB for one search

myst_enable_extensions = ["dollarmath", "amsmath", "html_image"]
myst_heading_anchors = 4  # links such as README.md#your-own-task
myst_links_external_new_tab = False
nb_execution_mode = "off"  # the outputs are those that are committed
# A widget needs a kernel; its still twin is HTML, with its alternative text
nb_mime_priority_overrides = [
    ("html", "text/html", 0),
    ("html", "application/vnd.jupyter.widget-view+json", None),
]

autodoc_member_order = "bysource"
autodoc_typehints = "none"  # numpydoc's sections say the types in words
autodoc_default_options = {"members": True}
napoleon_google_docstring = False
napoleon_use_param = napoleon_use_rtype = False  # in a type, [s] is a unit and no name
exclude_patterns = ["to_the_root"]  # what is copied as it is
suppress_warnings = ["myst.header"]  # some notebooks go from ## to ####


# Pages that the sidebar shows below another one, once that is opened. They do not stand in the pages themselves, where
# GitHub would show them as code
BELOW = {
    "docs/howto/install": ["docs/howto/browser"],
    "docs/playground": ["docs/stage", "docs/stepper"],
    "docs/method": ["docs/notation", "docs/when_similarity_helps"],
    "docs/grading": [
        "docs/ai_assistants",
        "docs/howto/checks_for_your_course",
        "notebooks/homework/*",
    ],
    "docs/real_robot": ["docs/bags"],
    "docs/results": ["docs/reproduction/README"],
    "docs/studies/index": ["docs/studies/*"],
    "datasets/README": ["datasets/*/README"],
    "CONTRIBUTING": [
        "docs/howto/architecture",
        "docs/howto/size",
        "docs/howto/release",
        "docs/howto/mistakes",
        "studies/benchmarks/README",
        "CHANGELOG",
        "SECURITY",
        "CODE_OF_CONDUCT",
    ],
}
MADE_OF = {
    "notebooks": "docs/lessons",
    "rlrobot_edu": "docs/api/index",
    "rlrobot_edu/widgets/stepper": "docs/stepper",
    "rlrobot_ros": "docs/api/rlrobot_ros",
}


def with_pages_below(app: Sphinx, page: str, source: list[str]) -> None:
    """Add the tree of the pages that stand below this one in the sidebar."""
    if page in BELOW:
        pages = "\n".join(f"/{name}" for name in BELOW[page])
        source[0] += f"\n\n```{{toctree}}\n:hidden:\n:glob:\n\n{pages}\n```\n"


def without_links_to_folders(app: Sphinx, page: str, source: list[str]) -> None:
    """A folder is a page on GitHub. Here a link to it leads to the page that was made of it; or else its words stay."""
    root = Path(app.srcdir).resolve()
    here = (root / page).parent

    def link_or_words(link: re.Match[str]) -> str:
        folder = (here / link[2]).resolve()
        if not folder.is_dir():
            return link[0]
        name = folder.relative_to(root).as_posix()
        candidates = [f"{name}/README", MADE_OF.get(name, f"docs/api/{folder.name}")]
        for candidate in candidates:
            made = root / f"{candidate}.md"
            if made.is_file():
                return f"[{link[1]}]({os.path.relpath(made, here)})"
        return link[1]

    source[0] = re.sub(r"(?<!!)\[([^\]\n]+)\]\(([\w./-]+)\)", link_or_words, source[0])


def with_levels(
    app: Sphinx, page: str, template: str, context: dict[str, Any], tree: object
) -> None:
    """Sphinx calls the captions in the sidebar headings, but does not say of which level; screen readers want it."""
    for name in ("furo_navigation_tree", "body"):
        if isinstance(context.get(name), str):
            context[name] = context[name].replace(
                'role="heading">', 'role="heading" aria-level="2">'
            )


LONGEST = 200  # characters of a description
MOST = 8  # paragraphs that it is taken from


CARD = "docs/card.png"  # the picture of a page that has none; make_site.py writes it
ADDRESS = os.environ.get("SITE_ADDRESS", "")


def picture_of(page: str, doctree: nodes.document) -> str:
    """The address of the picture that stands for a page: a lesson's card, the first on the page, or the project's."""
    path = CARD
    lesson = re.match(r"notebooks/(?:more/)?(\d\d)_", page)
    if lesson:
        path = f"docs/cards/{lesson[1]}.png"
    else:
        for image in doctree.findall(nodes.image):
            name = Path(image["uri"]).name  # by now its address in the site
            if name.endswith(".png"):
                path = f"_images/{name}"
                break
    here = "../" * page.count("/")
    return (ADDRESS or here) + path


def _is_picture(paragraph: nodes.paragraph) -> bool:
    return any(isinstance(child, nodes.image) for child in paragraph.children)


def with_card(
    app: Sphinx,
    page: str,
    template: str,
    context: dict[str, Any],
    doctree: nodes.document | None,
) -> None:
    """Title and description, which a search engine shows, and a card where somebody shares a link to the page."""
    if doctree is None:
        return
    paragraphs = [
        each for each in doctree.findall(nodes.paragraph) if not _is_picture(each)
    ]
    text = " ".join(" ".join(each.astext() for each in paragraphs[:MOST]).split())
    described = escape(shorten(text, LONGEST, placeholder=" …") or project)
    title = escape(unescape(re.sub("<[^>]*>", "", context.get("title") or project)))
    context["metatags"] = context.get("metatags", "") + (
        f'<meta name="description" content="{described}">'
        f'<meta property="og:type" content="website"><meta property="og:site_name" content="{project}">'
        f'<meta property="og:image" content="{picture_of(page, doctree)}">'
        f'<meta property="og:title" content="{title}"><meta property="og:description" content="{described}">'
    )


# A minus that follows nothing but an opening bracket or another sign belongs to its number
SIGN = re.compile(r"(<mo[^>]*>(?!&#x00029;|[\])|])[^<]+</mo>)<mo>(&#x02212;</mo>)")


def write_math(writer: HTML5Translator, node: nodes.math | nodes.math_block) -> None:
    """A formula as MathML."""
    is_block = isinstance(node, nodes.math_block)
    formula = convert(
        node.astext().replace(r"\!", ""), display="block" if is_block else "inline"
    )
    formula = SIGN.sub(r'\1<mo form="prefix">\2', formula)
    writer.body.append(f'<div class="math">{formula}</div>' if is_block else formula)
    raise nodes.SkipNode


def setup(app: Sphinx) -> None:
    app.connect("html-page-context", with_levels, priority=900)  # after the theme
    app.connect("html-page-context", with_card)
    app.add_html_math_renderer("mathml", (write_math, None), (write_math, None))
    app.connect("source-read", without_links_to_folders)
    app.connect("source-read", with_pages_below)
