"""Runs that name the class of a clip: data, loss, artifacts, evaluation, and `nscc classify`."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from nscc_command import invoke
from scipy.io import savemat
from small_runs import changed, trained

torch = pytest.importorskip("torch")

from nscc.diagnostics.arguments import WrongArgument  # noqa: E402
from nscc.diagnostics.diagnostic import Rejected  # noqa: E402
from nscc_runtime.light import Light  # noqa: E402
from nscc_training import load_run  # noqa: E402
from nscc_training.command_settings import EvaluationSettings  # noqa: E402
from nscc_training.data import ExposureSet, cut_batch, load_scenes  # noqa: E402
from nscc_training.evaluation.results import result_text  # noqa: E402
from nscc_training.evaluation.runs import evaluate  # noqa: E402
from nscc_training.loop.setup import make_setup  # noqa: E402
from nscc_training.loop.validation import validation_scenes  # noqa: E402
from nscc_training.losses import LOSSES  # noqa: E402
from nscc_training.made_scenes import DIRECTIONS, moving_texture  # noqa: E402
from nscc_training.protocol_scenes.clips import ClassWindow  # noqa: E402
from nscc_training.settings import settings_of  # noqa: E402

CLASSES: dict[str, dict[str, Any]] = {
    "shutter": {"class": "d", "slots": 16, "tile": [2, 2], "slot_us": 1000.0},
    "decoder": {"name": "classifier"},
    "data": {"protocol": "class-v1", "augment": False, "patch": 32, "scenes": 16, "val_items": 4},
    "loss": {"name": "class"},
    "train": {"steps": 2, "batch": 2, "validate_every": 2},
}


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return trained(tmp_path_factory.mktemp("classes") / "run", **CLASSES)


def class_folders(root: Path, side: int = 64, count: int = 2, name: str = "{label}{n}") -> Path:
    """Write clips that move left and right into folders of these names."""
    for label in ("left", "right"):
        (root / label).mkdir(parents=True)
        for number in range(count):
            generator = np.random.default_rng([number, len(label)])
            clip = moving_texture(generator, 16, side, label, 1.5)
            stored = np.rint(255 * np.moveaxis(clip, 0, 2)).astype(np.uint8)
            savemat(root / label / f"{name.format(label=label, n=number)}.mat", {"orig": stored})
    return root


def test_the_cross_entropy_is_that_of_the_loss() -> None:
    """The cross-entropy still distinguishes codes whose answers are nearly all right."""
    result = np.array([2.0, -1.0, 0.5])
    for label in ("a", "b", "c"):
        scene = SimpleNamespace(classes=("a", "b", "c"), label=label)
        scores = ClassWindow.scores(scene, result)  # type: ignore[arg-type]
        truth = torch.tensor([[float(name == label) for name in scene.classes]])
        loss = float(LOSSES["class"](torch.from_numpy(result)[None].float(), truth))
        assert scores["cross_entropy"] == pytest.approx(loss, rel=1e-5)
        assert scores["correct"] == float(label == "a")
    item = {"correct": 1.0, "class": "a", "decoded": "a", "file": "f", "cross_entropy": 0.25}
    values = {
        "method": "m",
        "protocol": "class-v1",
        "protocol_sha256": "",
        "settings": {},
        "mean": 1.0,
        "ci95": None,
        "sees": "capture",
        "items": [item],
        "left_out": [],
        "decoder_ms": None,
    }
    assert "100.0% correct, 95 % 100.0% to 100.0%, cross-entropy 0.250" in result_text(values)
    del item["cross_entropy"]
    assert "cross-entropy" not in result_text(values)


def test_each_patch_has_the_class_of_its_scene() -> None:
    """Scenes take the classes in turn. A batch holds each patch's class as a row with a 1, also
    after cutting."""
    settings = settings_of(CLASSES)
    scenes = load_scenes(settings.data, False, 16, 0, classes=DIRECTIONS)
    assert [scene.label for scene in scenes.train[:9]] == [*DIRECTIONS, "right"]
    data = replace(settings.data, together=2)
    drawn = ExposureSet(scenes, data, slots=16, batch=6, seed=0, classes=DIRECTIONS)[5]
    batch = cut_batch(drawn, data, 30000.0, torch.device("cpu"))
    labels = {scene.name: scene.label for scene in scenes.train}
    assert batch.classes is not None
    named = [DIRECTIONS[int(row.argmax())] for row in batch.classes]
    assert named == [labels[name.split(" ")[0]] for name in batch.names]
    assert batch.patches(2, 4).classes.tolist() == batch.classes[2:4].tolist()


def test_files_with_one_name_in_folders_of_two_classes_stay_apart(
    run: Path, tmp_path: Path
) -> None:
    """Their items, arrays, digests and validation classes are those of each file."""
    folder = class_folders(tmp_path / "clips", name="{n}")
    files = ["left/0.mat", "left/1.mat", "right/0.mat", "right/1.mat"]
    for number in range(2):  # the other class has other clips of these names
        assert (folder / files[number]).read_bytes() != (folder / files[2 + number]).read_bytes()
    result, arrays = evaluate(EvaluationSettings(str(run), folder, "class-v1"))
    assert [item["file"] for item in result["items"]] == files
    assert [entry["file"] for entry in result["data"]] == files
    assert {name for name in arrays if name.endswith("_truth")} == {
        f"{folder_name}_{n}_0_truth" for folder_name in ("left", "right") for n in range(2)
    }
    data = {
        **CLASSES["data"],
        "train": str(folder),
        "val": str(folder),
        "classes": ["left", "right"],
    }
    setup = make_setup(settings_of(CLASSES | {"data": data}))
    scenes = load_scenes(
        replace(setup.settings.data, val="procedural"), False, 16, 0, classes=DIRECTIONS
    )
    own = load_scenes(
        replace(setup.settings.data, train="procedural"), False, 16, 0, classes=setup.classes
    )
    assert [scene.name for scene in own.val] == [scene.name for scene in scenes.train] == files
    shown = validation_scenes(setup, own)
    truths = {str(scene.file): scene.truth_e.tolist() for scene in shown}
    assert truths == {name: [1, 0] if "left" in name else [0, 1] for name in files}


def test_the_loss_is_the_negative_logarithm_of_the_likelihood_of_the_right_class() -> None:
    """For likelihoods 0.5 and 0.8 of the right classes, the loss is their mean negative logarithm.
    A constant added to all logits changes nothing."""
    shares = torch.tensor([[0.5, 0.25, 0.25], [0.1, 0.1, 0.8]])
    truth = torch.tensor([[1.0, 0, 0], [0, 0, 1.0]])
    expected = -(np.log(0.5) + np.log(0.8)) / 2
    assert float(LOSSES["class"](shares.log() + 3, truth)) == pytest.approx(expected, rel=1e-6)


def test_result_and_card_report_the_share_of_right_classes(run: Path) -> None:
    result = json.loads((run / "result.json").read_text())
    assert set(result["headline"]) == {"effects", "correct"}
    assert {*result["stages"]} == {"soft", "hard", "compiled", "emulated", "compiled_equals_hard"}
    assert all("correct" in row and "psnr_db" not in row for row in result["robustness"])
    card = (run / "model_card.md").read_text()
    assert "% correct**" in card
    assert "dB" not in card
    head, *_, last = (run / "metrics.csv").read_text().splitlines()
    assert head == "step,split,loss,correct,words_per_slot,dead_share"
    kept = evaluate_validation(run)
    assert float(last.split(",")[3]) == kept["mean"]
    curves = load_run(run)
    assert f"{100 * kept['mean']:.1f}% correct" in repr(curves)
    assert "share of right classes" in curves._repr_html_()
    assert invoke(["view", str(run), "-o", str(run.parent / "v.png")], run).status == 0


def evaluate_validation(run: Path) -> dict[str, Any]:
    outcome = invoke(["evaluate", str(run), "--split", "val", "--json"], run)
    return json.loads(outcome.out)


def test_a_run_is_evaluated_on_procedural_scenes_and_on_folders(
    run: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    chosen = make_setup(settings_of(CLASSES)).protocol.changed(procedural=16)
    monkeypatch.setattr("nscc_training.evaluation.runs.load_protocol", lambda _name: chosen)
    first, arrays = evaluate(EvaluationSettings(str(run), Path("procedural"), "class-v1", 1))
    again, _ = evaluate(EvaluationSettings(str(run), Path("procedural"), "class-v1", 1))
    _, others = evaluate(EvaluationSettings(str(run), Path("procedural"), "class-v1", 2))
    assert first["items"] == again["items"]
    assert [item["class"] for item in first["items"]] == [*DIRECTIONS, *DIRECTIONS]
    assert not np.array_equal(arrays["right-0_0_class"], others["right-0_0_class"])
    assert first["mean"] == np.mean([i["class"] == i["decoded"] for i in first["items"]])
    assert arrays["right-0_0_class"].shape == arrays["right-0_0_truth"].shape == (8,)
    result, _ = evaluate(
        EvaluationSettings(str(run), class_folders(tmp_path / "clips"), "class-v1")
    )
    assert [item["class"] for item in result["items"]] == ["left", "left", "right", "right"]
    chip, _ = evaluate(EvaluationSettings(str(run), tmp_path / "clips", "class-v1", effects="all"))
    assert len(chip["items"]) == 4


def test_the_class_of_a_frame_does_not_depend_on_the_light_around_the_scene(run: Path) -> None:
    """A frame of a moving texture at 1500 electrons gets a share for each direction. Shares sum to
    1, largest first."""
    clip = moving_texture(np.random.default_rng(1), 16, 256, "up", 1.0)
    loaded = load_run(run)
    shares = loaded.classify(loaded.capture(Light.of_clip(1500 * clip)))
    assert set(shares) == {*DIRECTIONS}
    assert sum(shares.values()) == pytest.approx(1)
    assert [*shares.values()] == sorted(shares.values(), reverse=True)


def test_classify_prints_what_python_returns(run: Path, tmp_path: Path) -> None:
    """`nscc classify --json` prints the shares that Python returns. Without `--json` the lines have
    the same order."""
    clip = moving_texture(np.random.default_rng(1), 16, 256, "up", 1.0)
    np.save(tmp_path / "up.npy", (1500 * clip).astype(np.float32))
    line = ["run", "--like", str(run), "--scene", "up.npy", "-o", "f.npz"]
    assert invoke(line, tmp_path).status == 0
    outcome = invoke(["classify", str(run), "f.npz", "--json"], tmp_path)
    assert outcome.status == 0
    shares = json.loads(outcome.out)
    assert shares == load_run(run).classify(tmp_path / "f.npz")
    lines = invoke(["classify", str(run), "f.npz"], tmp_path).out.splitlines()
    assert [text.split()[0] for text in lines] == [*shares]


def test_each_command_refuses_runs_of_the_other_task(run: Path, tmp_path: Path) -> None:
    clip = moving_texture(np.random.default_rng(1), 16, 256, "up", 1.0)
    np.save(tmp_path / "up.npy", (1500 * clip).astype(np.float32))
    invoke(["run", "--like", str(run), "--scene", "up.npy", "-o", "f.npz"], tmp_path)
    refused = invoke(["reconstruct", str(run), "f.npz", "-o", "r.npz"], tmp_path)
    assert refused.status == 2
    assert "NS0821" in refused.err
    assert f"nscc classify {run} f.npz" in refused.err
    refused = invoke(["demo", "builtin:motion", "--run", str(run), "-o", "demo"], tmp_path)
    assert "names classes" in refused.err
    assert not (tmp_path / "demo").exists()
    refused = invoke(["classify", "clip", "f.npz"], tmp_path)
    assert refused.status == 2
    assert "NS0821" in refused.err
    for data, protocol in ((".", "video-v1"), ("procedural", "class-v1")):
        subject = str(run) if protocol == "video-v1" else "clip"
        line = ["evaluate", subject, "--data", data, "--protocol", protocol]
        class_folders(tmp_path / protocol)
        np.save(tmp_path / "any.npy", clip)
        assert "NS0821" in invoke(line, tmp_path).err
    with pytest.raises(WrongArgument, match="classify"):
        load_run(run).reconstruct(tmp_path / "f.npz")
    with pytest.raises(WrongArgument, match="classes"):
        load_run("clip").classify(tmp_path / "f.npz")


def test_classes_are_learned_from_folders_of_their_names(tmp_path: Path) -> None:
    """Folders named left and right give scenes of these classes. A folder whose name is no class is
    refused."""
    folder = class_folders(tmp_path / "clips", count=5)
    data = changed(CLASSES, "data", train=str(folder), classes=["left", "right"])
    settings = settings_of(data)
    scenes = load_scenes(settings.data, False, 16, 0, classes=("left", "right"))
    assert {scene.label for scene in (*scenes.train, *scenes.val)} == {"left", "right"}
    assert all(scene.name.startswith(scene.label) for scene in scenes.train)
    run = trained(tmp_path / "run", **data)
    assert load_run(run).folder.setup.classes == ("left", "right")
    with pytest.raises(Rejected) as refusal:
        load_scenes(settings.data, False, 16, 0, classes=("left", "up"))
    assert "not named after a class" in refusal.value.diagnostics[0].message


@pytest.mark.parametrize(
    ("section", "values", "phrase"),
    [
        ("loss", {"name": "l1"}, "loss.name"),
        ("loss", {"name": "class+l1"}, "loss.name"),
        ("data", {"augment": True}, "data.augment"),
        ("data", {"classes": ["left"]}, "data.classes"),
        ("data", {"classes": ["left", "left"]}, "data.classes"),
        ("data", {"classes": ["left", "sideways"]}, "data.classes"),
        ("data", {"protocol": "video-v1"}, "loss.name"),
        ("decoder", {"name": "unet2d"}, "decoder.name"),
        ("shutter", {"relaxation": "tried"}, "shutter.relaxation"),
    ],
)
def test_settings_that_do_not_go_together_are_refused(
    section: str, values: dict[str, Any], phrase: str
) -> None:
    with pytest.raises(Rejected) as refusal:
        make_setup(settings_of(changed(CLASSES, section, **values)))
    assert refusal.value.diagnostics[0].code == "NS0815"
    assert phrase in refusal.value.diagnostics[0].message


def test_a_source_of_ones_own_gives_each_scene_a_class(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "own_classes.py").write_text(
        "import numpy as np\n"
        "def scenes(kind, part, slots, seed):\n"
        "    light = np.random.default_rng(len(part)).random((2, slots, 40, 40))\n"
        "    return [('a', light[0], 'left'), ('b', light[1], 'right')]\n"
        "def without(kind, part, slots, seed):\n"
        "    return [scene[:2] for scene in scenes(kind, part, slots, seed)]\n"
    )
    monkeypatch.syspath_prepend(str(tmp_path))
    classes = ("left", "right")
    data = settings_of(
        changed(CLASSES, "data", train="own_classes:scenes", val="own_classes:scenes")
    ).data
    scenes = load_scenes(data, False, 16, 0, classes=classes)
    assert [scene.label for scene in scenes.train] == ["left", "right"]
    for source, known in (("own_classes:without", classes), ("own_classes:scenes", ())):
        with pytest.raises(Rejected) as refusal:
            load_scenes(replace(data, train=source), False, 16, 0, classes=known)
        assert refusal.value.diagnostics[0].code == "NS0822"
