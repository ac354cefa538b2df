"""Descriptions of images and planes in reports and summaries."""

from __future__ import annotations

from nscc.chips.target import Target
from nscc.lower.resources import time_text
from nscc.mappings import JsonObject
from nscc.program.problems import counted
from nscc.prove.meaning import reaches
from nscc.words.container import Container
from nscc.words.cost import words_us
from nscc.words.counts import counts_by_name
from nscc.words.encoding import matching
from nscc.words.pictures import KeptImage, KeptPlane, Picture, Pictures


def pictures_us(pictures: Pictures, target: Target) -> float:
    """Return the time from the last slot to the first readout, in microseconds, if parameters have
    their starts; 0 without images and planes.

    It consists of words, launches, and the waits until IN (the level sent to all pixels) is stable
    after it changes."""
    kernels = [[matching(word, target.words) for word in kernel] for kernel in pictures.kernels]
    total_us, level = 0.0, None
    for launch in pictures.executed():
        words = kernels[launch.kernel]
        analog = sum(1 for word in words if word is not None and word.analog)
        total_us += target.launch_us + words_us(analog, len(words) - analog, target)
        if launch.level not in (None, level):
            level = launch.level
            total_us += target.in_settle_us
    return total_us


def picture_report(container: Container) -> JsonObject:
    """Return the part of `--emit report` about images and planes, as JSON values.

    Its keys are `images`, `planes` and, if there are any, `states`, each a dict by name;
    `images_words_total` (executed words); and `images_us`, the time in microseconds."""
    pictures = container.pictures
    costs = {cost.name: cost for cost in pictures.costs}
    reach, counts = reaches(pictures), counts_by_name(pictures)

    def item_report(item: Picture | KeptPlane | KeptImage) -> JsonObject:
        """Return what one image or plane costs as JSON values: `words` and `reach` (in pixels).

        Images also have `peak_gain` and `noise_gain`; counts also have `peak_count` and
        `electrons_per_count`."""
        cost = costs[item.name]
        report: JsonObject = {"words": cost.words, "reach": max(reach[item.name])}
        if item.name not in pictures.planes:
            report |= {"peak_gain": cost.peak_gain, "noise_gain": cost.noise_gain}
        if item.name in counts:
            unit_e = pictures.count_steps * container.target.electrons_per_step
            report |= {"peak_count": float(counts[item.name].peak), "electrons_per_count": unit_e}
        return report

    states = {state.name: item_report(state) for state in pictures.states}
    states |= {image.name: item_report(image) for image in pictures.kept_images}

    return {
        "images": {item.name: item_report(item) for item in pictures.items if not item.is_plane},
        "planes": {item.name: item_report(item) for item in pictures.items if item.is_plane},
        **({"states": states} if states else {}),
        "images_words_total": pictures.words,
        "images_us": pictures_us(pictures, container.target),
    }


def with_pictures(report: JsonObject, container: Container) -> JsonObject:
    """Return a build report with the part about images and planes (`picture_report`).

    Their time is added to the report's `frame_us`. `report` itself is not changed."""
    pictures = picture_report(container)
    pictures["frame_us"] = round(report["frame_us"] + pictures["images_us"], 6)
    return {**report, **pictures}


def picture_rows(container: Container) -> list[tuple[str, str]]:
    """Return the rows (label, text) of a summary about images and planes: one each, then the sum of
    words and their time.

    The labels are "image", "plane", "state" and, for the sum, "after"."""
    pictures, target = container.pictures, container.target
    reach = reaches(pictures)
    kinds = {item.name: "plane" if item.is_plane else "image" for item in pictures.items}
    kinds |= dict.fromkeys(pictures.stepping, "state")
    counts = counts_by_name(pictures)
    rows = []
    for cost in pictures.costs:
        text = f"{cost.name}: {counted(cost.words, 'word')}, reach {max(reach[cost.name])}"
        if cost.name in counts:
            text += f", counts to {counts[cost.name].peak}, noise gain {cost.noise_gain:.3g}"
        elif cost.name not in pictures.planes:
            text += f", peak gain {cost.peak_gain:.3g}, noise gain {cost.noise_gain:.3g}"
        rows.append((kinds[cost.name], text))
    total = counted(pictures.words, "word")
    rows.append(
        ("after", f"{total} after the last slot, {time_text(pictures_us(pictures, target))}")
    )
    return rows
