"""One self-contained HTML page: blocks of HTML, style, and a player of frames.

Nothing is fetched from anywhere: pictures are embedded, the script is below.
"""
import base64
import html
import json
import re

WIDTH = 15.6 * 72  # points of a plot as wide as the page: fonts have the same size in all
STYLE = """
:root { --ink: #1f2933; --soft: #667; --line: #dfe3e8; --blue: #2b6cb0; --red: #b5332e; --green: #2f7d4f; }
* { box-sizing: border-box; }
body { font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; color: var(--ink); max-width: 1240px; margin: 0 auto;
  padding: 20px 28px 60px; background: white; }
h1 { font-size: 26px; margin: 0 0 4px; } h2 { font-size: 20px; margin: 38px 0 10px; border-bottom: 2px solid var(--line);
  padding-bottom: 4px; } h3 { font-size: 16px; margin: 22px 0 6px; }
nav { font-size: 13px; margin: 10px 0 0; } nav a { color: var(--blue); margin-right: 14px; text-decoration: none; }
p.soft, .soft { color: var(--soft); font-size: 13px; } p { margin: 6px 0; }
.tiles { display: flex; flex-wrap: wrap; gap: 10px; margin: 16px 0 4px; }
.tile { border: 1px solid var(--line); border-radius: 6px; padding: 8px 14px; min-width: 112px; }
.tile b { display: block; font-size: 20px; font-variant-numeric: tabular-nums; } .tile span { color: var(--soft); font-size: 12px; }
.badge { display: inline-block; border-radius: 4px; padding: 1px 9px; color: white; font-size: 13px; vertical-align: middle; }
.done { background: var(--green); } .stopped { background: var(--red); } .unfinished { background: #b7791f; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: 13px; margin: 8px 0; }
th, td { text-align: left; padding: 4px 12px 4px 0; border-bottom: 1px solid var(--line); vertical-align: top; }
th { color: var(--soft); font-weight: 600; } td.number { text-align: right; font-variant-numeric: tabular-nums; }
th.number { text-align: right; } td { overflow-wrap: anywhere; }
td:first-child, td.number { white-space: nowrap; overflow-wrap: normal; }
.failure { border-left: 5px solid var(--red); background: #fdf3f2; padding: 8px 16px; margin: 12px 0; }
.failure dt, .try dt { float: left; clear: left; width: 62px; color: var(--soft); } .failure dd { margin: 0 0 2px 62px; }
.warning { border-left: 5px solid #d69e2e; background: #fffaf0; padding: 6px 16px; margin: 8px 0; }
img { max-width: 100%; display: block; } .picture { border: 1px solid var(--line); border-radius: 6px; margin: 8px 0; }
.player img { width: 100%; }
.player { border: 1px solid var(--line); border-radius: 6px; padding: 6px 10px 10px; margin: 8px 0; }
.player .bar { display: flex; align-items: center; gap: 10px; margin-top: 4px; } .player input[type=range] { flex: 1; }
.player button { font: inherit; width: 84px; } .player output { font-variant-numeric: tabular-nums; min-width: 150px; }
pre { background: #f5f7fa; padding: 10px 14px; font-size: 12px; white-space: pre-wrap; overflow-wrap: anywhere; }
details summary { cursor: pointer; color: var(--blue); font-size: 13px; }
@media print { nav, .bar { display: none; } h2 { break-after: avoid; } img, table { break-inside: avoid; } }
"""

SCRIPT = """
'use strict';
const players = [...document.querySelectorAll('.player')].map(box => {
  const frames = JSON.parse(box.querySelector('script').textContent);
  const image = box.querySelector('img'), slider = box.querySelector('input[type=range]');
  const button = box.querySelector('button'), text = box.querySelector('output'), speed = box.querySelector('select');
  const player = {frames, timer: null};
  player.show = i => {
    slider.value = i;
    image.src = frames[i].picture;
    text.textContent = 't = ' + frames[i].time + ', step ' + frames[i].step;
  };
  player.showTime = time => {
    let best = 0;
    frames.forEach((frame, i) => {
      if (Math.abs(frame.time - time) < Math.abs(frames[best].time - time)) best = i;
    });
    player.show(best);
  };
  player.go = i => {
    player.show(i);
    const together = document.getElementById('together');
    if (together && together.checked)
      players.forEach(other => { if (other !== player) other.showTime(frames[i].time); });
  };
  player.stop = () => { clearTimeout(player.timer); player.timer = null; button.textContent = 'Play'; };
  const advance = () => {
    const next = Number(slider.value) + 1;
    if (next >= frames.length) { player.stop(); return; }
    player.go(next);
    player.timer = setTimeout(advance, 1000 / Number(speed.value));
  };
  button.addEventListener('click', () => {
    if (player.timer !== null) { player.stop(); return; }
    if (Number(slider.value) === frames.length - 1) player.go(0);
    button.textContent = 'Pause';
    player.timer = setTimeout(advance, 1000 / Number(speed.value));
  });
  slider.addEventListener('input', () => { player.stop(); player.go(Number(slider.value)); });
  player.show(frames.length - 1);
  return player;
});
document.body.dataset.players = players.length;
"""


def escaped(text):
    return html.escape(str(text))


def shown(value):
    """A number as a table has it: whole numbers without a point, others with six digits."""
    if isinstance(value, str):
        return value
    return f"{value:.0f}" if value == int(value) and abs(value) < 1e9 else f"{value:.6g}"


class Page:
    def __init__(self, title, subtitle=""):
        self.title = title
        self.header = f"<h1>{escaped(title)}</h1>" + (f'<p class="soft">{escaped(subtitle)}</p>' if subtitle else "")
        self.parts = []
        self.sections = []

    # ------------------------------------------------------------------ blocks
    def add(self, text):
        self.parts.append(text)

    def section(self, name, identifier):
        self.sections.append((name, identifier))
        self.add(f'<h2 id="{identifier}">{escaped(name)}</h2>')

    def heading(self, text):
        self.add(f"<h3>{escaped(text)}</h3>")

    def paragraph(self, text, css_class=""):
        self.add(f'<p class="{css_class}">{escaped(text)}</p>')

    def box(self, text, css_class):
        self.add(f'<div class="{css_class}">{escaped(text)}</div>')

    def explanation(self, title, entries):
        """{"cause": ..., "why": ...} in a frame."""
        rows = "".join(f"<dt>{escaped(name)}</dt><dd>{escaped(text)}</dd>" for name, text in entries.items() if text)
        self.add(f'<div class="failure"><b>{escaped(title)}</b><dl>{rows}</dl></div>')

    def tiles(self, entries):
        self.add('<div class="tiles">' + "".join(
            f'<div class="tile"><b>{escaped(value)}</b><span>{escaped(name)}</span></div>' for name, value in entries) + "</div>")

    def badge(self, state, text):
        self.add(f'<p><span class="badge {state}">{escaped(state)}</span> {escaped(text)}</p>')

    def table(self, header, rows, identifier=""):
        """Numbers are set to the right; nothing without rows."""
        if not rows:
            return
        def cell(tag, value, is_number):
            text = escaped(shown(value))
            if tag == "th":
                text = text.replace("_", "_<wbr>")  # long names of columns may be broken there
            return f'<{tag}{" class=number" if is_number else ""}>{text}</{tag}>'

        is_number = [not isinstance(value, str) for value in rows[0]]
        head = "".join(cell("th", name, right) for name, right in zip(header, is_number))
        body = "".join("<tr>" + "".join(cell("td", value, not isinstance(value, str)) for value in row) + "</tr>\n" for row in rows)
        name = f' id="{identifier}"' if identifier else ""
        self.add(f'<div class="wide"><table{name}><thead><tr>{head}</tr></thead>\n<tbody>{body}</tbody></table></div>')

    def details(self, summary, text):
        self.add(f"<details><summary>{escaped(summary)}</summary><pre>{escaped(text)}</pre></details>")

    def plot(self, svg, name):
        """An SVG text; nothing for None."""
        if svg is not None:
            data = base64.b64encode(svg.encode()).decode()
            width = float(re.search(r'<svg[^>]* width="([0-9.]+)pt"', svg)[1])
            self.add(f'<img alt="{escaped(name)}" style="width: {min(100.0, 100.0 * width / WIDTH):.1f}%" '
                     f'src="data:image/svg+xml;base64,{data}">')

    def picture(self, data, kind, name):
        self.add(f'<img class="picture" alt="{escaped(name)}" src="{data_address(data, kind)}">')

    def player(self, frames):
        """frames: [(time, step, JPEG)]"""
        text = json.dumps([{"time": float(f"{time:.6g}"), "step": step, "picture": data_address(data, "jpeg")}
                           for time, step, data in frames])
        speeds = "".join(f'<option value="{n}"{" selected" if n == 8 else ""}>{n} pictures/s</option>' for n in (2, 4, 8, 16))
        self.add(f'<div class="player"><img alt="animation" src="{data_address(frames[-1][2], "jpeg")}">'
                 f'<div class="bar"><button type="button">Play</button>'
                 f'<input type="range" min="0" max="{len(frames) - 1}" value="{len(frames) - 1}" aria-label="time">'
                 f'<output></output><select aria-label="speed">{speeds}</select></div>'
                 f'<script type="application/json">{text}</script></div>')

    # -------------------------------------------------------------------- page
    def text(self):
        links = "".join(f'<a href="#{identifier}">{escaped(name)}</a>' for name, identifier in self.sections)
        body = "\n".join(self.parts)
        return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{escaped(self.title)}</title>\n'
                f'<link rel="icon" href="data:,">\n<meta name="viewport" content="width=device-width">\n'
                f"<style>{STYLE}</style></head>\n<body>\n{self.header}\n<nav>{links}</nav>\n{body}\n<script>{SCRIPT}</script>\n</body></html>\n")


def data_address(data, kind):
    return f"data:image/{kind};base64,{base64.b64encode(data).decode()}"
