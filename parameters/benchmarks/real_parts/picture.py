#!/usr/bin/python3
"""The parts as scripts/bench real_parts leaves them, side by side; colours: von Mises stress, each part with a scale of its own.

    picture.py DIRECTORY_OF_THE_BENCHMARK OUTPUT.png
"""
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "scripts"))
from vtk_pictures import run_under_a_display

run_under_a_display("picture.py")
import numpy as np
from PIL import Image, ImageDraw, ImageFont
from matplotlib import colormaps
from stickslip import Results
from vtk_pictures import add_scalar, cell_edges, line_actor, lookup_table, outline_edges, picture_of, split_by_value, surface_actor, surface_of, warped
from vtk.util.numpy_support import vtk_to_numpy

# part: title, load time, factor on the displacements, direction of the view, width of its panel
PARTS = {
    "flange, tetrahedra": ("Bolted flange", 2, 200, (0.8, -1.0, 0.5), 500),
    "press fit, tetrahedra": ("Press fit", 1, 200, (0.7, 0.5, 0.8), 500),
    "bracket, tetrahedra": ("Angle bracket", 2, 50, (0.45, -1.0, 0.45), 500),
    "lug, tetrahedra": ("Pin in a lug", 1, 50, (0.2, -0.7, 1.0), 750),
    "snap fit, tetrahedra": ("Snap-fit (triangles)", 0.45, 1, (0.0, 0.0, 1.0), 750),
}
HEIGHT = 420


def panel(directory, title, time, factor, direction, width):
    run = Results(directory)
    step = min(run.bodies.steps, key=lambda step: abs(step.time - time))
    grid = warped(step.vtk(), factor)
    stresses = add_scalar(grid, "von_mises_stress", None)
    is_flat = direction[:2] == (0.0, 0.0)
    table = lookup_table(colormaps["turbo"], (0.0, np.quantile(stresses, 0.995)))
    actors = []
    for part in split_by_value(grid, "body"):
        surface = surface_of(part)
        add_scalar(surface, "von_mises_stress", None)
        actors += [surface_actor(surface, table, is_flat), line_actor(cell_edges(part), (0.1, 0.1, 0.1), 1.0, 0.25),
                   line_actor(outline_edges(surface), (0.05, 0.05, 0.05), 2.5)]
    image, _ = picture_of(actors, (2 * width, 2 * (HEIGHT - 40)), direction, (0.0, 1.0, 0.0) if is_flat else (0.0, 0.0, 1.0))
    result = Image.new("RGB", (width, HEIGHT), "white")
    result.paste(Image.fromarray(image).resize((width, HEIGHT - 40), Image.LANCZOS), (0, 40))
    enlarged = f", displacements × {factor}" if factor != 1 else ""
    font = ImageFont.truetype("DejaVuSans.ttf", 17)
    ImageDraw.Draw(result).text((12, 10), f"{title}: 0 to {np.quantile(stresses, 0.995):.0f} MPa{enlarged}", "black", font)
    return result


def main():
    directory, output = pathlib.Path(sys.argv[1]), sys.argv[2]
    picture = Image.new("RGB", (1500, 2 * HEIGHT), "white")
    x = y = 0
    for name, of_part in PARTS.items():
        image = panel(directory / name, *of_part)
        if x + image.width > picture.width:
            x, y = 0, y + HEIGHT
        picture.paste(image, (x, y))
        x += image.width
    picture = picture.resize((1000, 560), Image.LANCZOS)
    picture.quantize(64, method=Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE).save(output, optimize=True)


main()
