"""Check the settings of runs with classes."""

from __future__ import annotations

from nscc_training.import_paths import is_import_path
from nscc_training.losses import CLASS
from nscc_training.made_scenes import DIRECTIONS
from nscc_training.problems import invalid_setting
from nscc_training.protocols import Protocol
from nscc_training.settings import RunSettings


def classes_of(settings: RunSettings, protocol: Protocol) -> tuple[str, ...]:
    """Return the classes of a configuration; empty if its protocol has no classes."""
    return settings.data.classes or DIRECTIONS if protocol.classifies else ()


def check_classes(settings: RunSettings, protocol: Protocol) -> None:
    """Raise Rejected (NS0815) for settings that exclude classes, or that require classes."""
    classes, data = classes_of(settings, protocol), settings.data
    if not classes:
        if data.classes:
            raise invalid_setting("data.classes", "classes need [data] protocol class-v1")
        if CLASS in settings.loss.name.split("+"):
            raise invalid_setting("loss.name", "`class` needs [data] protocol class-v1")
        return
    if settings.loss.name != CLASS and not is_import_path(settings.loss.name):
        raise invalid_setting("loss.name", "classes are learned with the loss `class`")
    if len(set(classes)) < max(2, len(classes)):
        raise invalid_setting("data.classes", "name at least two classes, each once")
    if unknown := [c for c in classes if c not in DIRECTIONS and data.train == "procedural"]:
        raise invalid_setting(
            "data.classes", f"procedural scenes have the classes {', '.join(DIRECTIONS)}, not "
            f"{unknown[0][:40]}",
        )  # fmt: skip
    if data.augment:
        raise invalid_setting(
            "data.augment", "rotated, mirrored and reversed clips may change their class: set it "
            "to false",
        )  # fmt: skip
    if settings.shutter.learn and settings.shutter.relaxation == "tried":
        raise invalid_setting(
            "shutter.relaxation", "trials need the loss of each pixel, and a class has one loss: "
            "use straight-through or search",
        )  # fmt: skip
