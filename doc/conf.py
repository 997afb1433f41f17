"""Sphinx: these pages as HTML, without a network. Built by scripts/manual.

The source directory is that of the whole program, so that pages link to files
beside doc/ as they do in the repository.
"""
import pathlib
import shutil

project = "stickslip"
copyright = "the authors of stickslip"
extensions = ["myst_parser", "sphinx.ext.mathjax"]
source_suffix = {".md": "markdown"}
root_doc = "doc/index"
include_patterns = ["README.md", "doc/*.md", "doc/**/*.png", "tests/README.md", "parameters/benchmarks/README.md", "parameters/benchmarks/*/README.md"]
exclude_patterns = ["build*", ".git"]
myst_enable_extensions = ["dollarmath", "amsmath"]
myst_heading_anchors = 3
myst_update_mathjax = False  # that is for MathJax 3; Debian has 2
highlight_language = "text"
smartquotes = False  # "--option" is not a dash
html_theme = "sphinx_rtd_theme"
html_title = "stickslip"
html_static_path = ["manual.css"]
html_css_files = ["manual.css"]
html_copy_source = False
html_show_sphinx = False

# Formulas: what MathJax of Debian (libjs-mathjax) needs for TeX with SVG, copied beside the pages.
MATHJAX = pathlib.Path("/usr/share/javascript/mathjax")
MATHJAX_FILES = ["MathJax.js", "config/TeX-AMS_SVG-full.js", "extensions", "jax/element/mml", "jax/input/TeX",
                 "jax/output/SVG/jax.js", "jax/output/SVG/config.js", "jax/output/SVG/autoload", "jax/output/SVG/fonts/TeX"]
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_SVG-full"
mathjax2_config = {"messageStyle": "none", "SVG": {"linebreaks": {"automatic": True}},
                   # only formulas that the pages mark as such, no dollars in code
                   "tex2jax": {"processClass": "math", "ignoreClass": "document"},
                   "showMathMenu": False}  # the menu would load what has not been copied


def copy_mathjax(app, exception):
    if exception is not None or app.builder.format != "html":
        return
    for name in MATHJAX_FILES:
        target = pathlib.Path(app.outdir) / "_static" / "mathjax" / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if (MATHJAX / name).is_dir():
            shutil.copytree(MATHJAX / name, target, dirs_exist_ok=True)
        else:
            shutil.copyfile(MATHJAX / name, target)


def setup(app):
    app.connect("build-finished", copy_mathjax)
