"""The pictures of a report: which steps are shown, as stills and as frames of an
animation, side by side for several runs.
"""
import io

from PIL import Image

import run_pictures

DPI_OF_FRAMES, DPI_OF_PICTURES = 65, 85  # of 16 x 8


def chosen_steps(run, times):
    """Steps with fields nearest to the times; by default where the load turns, or evenly."""
    steps = run.bodies.steps
    if times is None:
        requested = run.parameters.get("Load stepping/Requested times") if run.parameters else ""
        times = [float(word) for word in requested.split(",") if word.strip()][:3] if requested else []
        last = steps[-1].time
        for share in (0.25, 0.5, 0.75):
            if len(times) < 3 and all(abs(share * last - t) > 0.1 * abs(last) for t in times):
                times.append(share * last)
        times.append(last)
    nearest = {min(steps, key=lambda step: abs(step.time - time)).number for time in times}
    return [step for step in steps if step.number in nearest]


def frame_steps(run, n):
    """At most n steps, evenly over those with fields, the first and the last among them."""
    steps = run.bodies.steps
    if len(steps) <= n:
        return steps
    return [steps[round(i * (len(steps) - 1) / (n - 1))] for i in range(n)] if n > 1 else steps[-1:]


def jpeg_of(figure, quality):
    data = io.BytesIO()
    figure.savefig(data, format="png", facecolor="white")
    picture = Image.open(data).convert("RGB")
    data = io.BytesIO()
    picture.save(data, "jpeg", quality=quality, optimize=True, subsampling=0)
    return data.getvalue()


def add_pictures(page, runs, arguments):
    with_fields = [run for run in runs if run.bodies.steps]
    if not with_fields or arguments.no_pictures:
        return
    page.section("Pictures", "pictures")
    page.paragraph("The bodies in their true deformation. Colours and axes are the same in all pictures"
                   + (" of a run" if len(runs) == 1 else ", those of the other runs included") + ".", "soft")
    options = run_pictures.PictureOptions(field=arguments.field, component=arguments.component, warp=arguments.warp,
                                          view=tuple(arguments.view), dpi=DPI_OF_FRAMES)
    n_frames = max(2, arguments.frames // len(with_fields)) if arguments.frames > 0 else 0
    frames = {run.label: frame_steps(run, n_frames) if n_frames else [] for run in with_fields}
    stills = {run.label: chosen_steps(run, arguments.times) for run in with_fields}
    if len(with_fields) > 1 and arguments.times is None:
        stills = {run.label: [] if n_frames else run.bodies.steps[-1:] for run in with_fields}
    all_pictures = {}
    for run in with_fields:
        steps = {step.number: step for step in [*frames[run.label], *stills[run.label]]}
        all_pictures[run.label] = run_pictures.RunPictures(run, options, [steps[n] for n in sorted(steps)])
    run_pictures.RunPictures.share_colours(list(all_pictures.values()))

    if n_frames and any(len(frames[run.label]) > 1 for run in with_fields):
        page.heading("Animation")
        if len(with_fields) > 1:
            page.add('<p class="soft"><label><input type="checkbox" id="together" checked> show the same time in all</label></p>')
        for run in with_fields:
            page.player([(step.time, step.number, jpeg_of(draw(all_pictures[run.label], run, step, runs), 80))
                         for step in frames[run.label]])
    options.dpi = DPI_OF_PICTURES
    for run in with_fields:
        if len(runs) == 1:
            page.heading("At chosen times")
        for step in stills[run.label]:
            page.picture(jpeg_of(draw(all_pictures[run.label], run, step, runs), 88), "jpeg", f"{run.label} at t = {step.time:g}")


def draw(pictures, run, step, runs):
    return pictures.draw(step, run.label if len(runs) > 1 else None)
