"""Pages in a real browser without a screen: what its document holds after the scripts have run."""
import pathlib
import re
import shutil
import subprocess
import tempfile

NAMES = ("chromium", "chromium-browser", "google-chrome")


def browser():
    """The command, or None where there is none."""
    return next(filter(None, map(shutil.which, NAMES)), None)


class Rendered:
    def __init__(self, document, console):
        self.document = document  # the text of the document after its scripts
        self.console = console  # messages of scripts and the network


# Scripts' errors become a title, which the document then has: headless browsers hide their console.
WATCH = ("<script>window.addEventListener('error', e => { document.title = 'SCRIPT ERROR ' + (e.message || e.target.outerHTML); },"
         " true);</script>")


def load(page, milliseconds=5000):
    """Loads a file where it is, and lets its scripts run for so long."""
    with tempfile.TemporaryDirectory() as directory:
        result = subprocess.run(
            [browser(), "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--enable-logging=stderr",
             f"--user-data-dir={directory}/profile", "--host-resolver-rules=MAP * ~NOTFOUND",
             f"--virtual-time-budget={milliseconds}", "--dump-dom", pathlib.Path(page).as_uri()],
            capture_output=True, text=True, timeout=240)
    console = [line for line in result.stderr.splitlines() if ":CONSOLE" in line]
    return Rendered(result.stdout, console)


def render(page, script=""):
    """Loads a file alone, elsewhere; `script` is run at its end. Throws what the browser does not survive."""
    text = pathlib.Path(page).read_text().replace("<head>", "<head>" + WATCH, 1)
    text = text.replace("</body>", f"<script>{script}</script></body>", 1)
    with tempfile.TemporaryDirectory() as directory:
        copy = pathlib.Path(directory) / "page.html"
        copy.write_text(text)
        return load(copy)


def errors_of(rendered):
    """What scripts or missing files said."""
    found = re.findall(r"<title>(SCRIPT ERROR [^<]*)", rendered.document)
    return found + rendered.console
