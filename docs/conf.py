"""The site: `make docs`. Sources are the repository's own pages, so that a link means the same here
and where the files are read."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parent
BUILD = DOCS.parent / "build"
sys.path.insert(0, str(DOCS))

import nscc  # noqa: E402
from nscc_site.digest import source_digest  # noqa: E402

project = "nscc"
author = "nscc contributors"
copyright = "nscc contributors"
release = version = nscc.__version__

extensions = [
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx.ext.viewcode",
    "myst_nb",
    "sphinx_copybutton",
    "nscc_site",
]
root_doc = "docs/index"
include_patterns = [
    "*.md",
    "docs/*.md",
    "docs/**/*.md",
    "examples/README.md",
    "runtime/PROTOCOL.md",
    "runtime/firmware/README.md",
    "training/results/README.md",
    "training/results/details.md",
]
myst_enable_extensions = ["colon_fence", "deflist"]
myst_heading_anchors = 4

# Notebooks run where they leave nothing behind, with nobody's own settings; what they gave is kept
# until cells or nscc change.
nb_execution_mode = "cache"
nb_execution_cache_path = str(BUILD / "site-notebooks" / source_digest())
nb_execution_in_temp = True
nb_execution_raise_on_error = True
nb_execution_timeout = 600
nb_merge_streams = True
_first = BUILD / "site-ipython" / "profile_default" / "startup" / "first.py"
_first.parent.mkdir(parents=True, exist_ok=True)
shutil.copy(DOCS / "nscc_site" / "kernel.py", _first)
os.environ["IPYTHONDIR"] = str(_first.parents[2])

# What the packages themselves offer leads somewhere; what lies below that, or is others', need not.
nitpicky = True
nitpick_ignore_regex = [("py:.*", r"(?!nscc\w*\.\w+$).*")]
suppress_warnings = ["misc.highlighting_failure"]  # of cells that write files of other languages
autodoc_mock_imports = ["deepinv"]
default_role = "literal"
autodoc_member_order = "bysource"
autodoc_typehints_format = "short"
autodoc_preserve_defaults = True
python_use_unqualified_type_names = True
napoleon_google_docstring = False
napoleon_use_rtype = False
linkcheck_timeout = 20

html_theme = "furo"
html_title = f"nscc {version}"
html_logo = html_favicon = "static/logo.svg"
html_theme_options = {"sidebar_hide_name": False, "top_of_page_buttons": ["view"]}
# Previews of links need the address at which the site will be.
html_baseurl = os.environ.get("NSCC_SITE_URL", "")
html_search_scorer = str(DOCS / "nscc_site" / "scorer.js")

# What is copied are commands: neither their prompt nor what they print.
copybutton_prompt_text = r"\$ |>>> |\.\.\. "
copybutton_prompt_is_regexp = True
html_static_path = ["static"]
html_css_files = ["site.css"]
html_extra_path = ["static/index.html"]
html_show_sphinx = False
