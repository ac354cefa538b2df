"""Training with two buckets: what one leaves out the other has."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import torch
from small_runs import trained

from nscc.container_proof import shutters_of_pixels
from nscc.diagnostics.arguments import WrongArgument
from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime import capture
from nscc_training import load_run
from nscc_training.command_settings import DecoderStudySettings
from nscc_training.decoders.declared import DECODERS, DecoderTask
from nscc_training.decoders.decoder_building import make_decoder
from nscc_training.encoders import ShutterSpec, make_encoder
from nscc_training.loop.setup import make_setup
from nscc_training.programs import Chip, compiled, program_of
from nscc_training.sensor_model import SensorModel, differentiable_capture
from nscc_training.settings import settings_of
from nscc_training.tradeoff.decoder import decoder_points

CHIP = Chip("dual-tap", 1000.0)
TWO = {"class": "e", "slots": 4, "tile": [2, 2], "buckets": 2, "init": "random"}
SMALL = {"target": "dual-tap", "slot_us": 1000.0, **TWO}


def encoder_of(kind: str, relaxation: str = "straight-through"):
    spec = ShutterSpec(
        kind,
        6,
        (3, 2),
        length=2 if kind == "c" else None,
        rows=4 if kind == "codebook" else None,
        buckets=2,
    )
    return make_encoder(spec, "random", 5, relaxation)


@pytest.mark.parametrize("kind", ["b", "c", "d", "e", "codebook"])
def test_every_class_shares_out_all_light(kind: str) -> None:
    """The compiled planes, and the capture that gradients pass, beside sums by numpy."""
    encoder = encoder_of(kind)
    container = compiled(program_of(encoder, CHIP), CHIP).container
    assert container is not None
    opened = shutters_of_pixels(container)["shutter"][:, :3, :2]
    opened = np.unpackbits(opened, axis=-1, count=6, bitorder="little").transpose(0, 3, 1, 2)
    assert np.array_equal(opened.sum(axis=0), np.ones((6, 3, 2)))
    assert np.array_equal(opened[0], encoder.hard().numpy())
    light = np.random.default_rng(1).uniform(0, 900, (2, 6, 3, 2)).astype(np.float32)
    sensor = SensorModel(full_well_e=30000.0, electrons_per_lsb=30000 / 255)
    found = differentiable_capture(torch.from_numpy(light), encoder, sensor)
    wanted = np.einsum("ynrc,bnrc->ybrc", light.astype(np.float64), opened)
    np.testing.assert_allclose(found.exposure_e.detach().numpy(), wanted, rtol=1e-6)
    np.testing.assert_array_equal(found.frame.detach().numpy(), np.rint(wanted / (30000 / 255)))


def test_buckets_have_opposite_gradients() -> None:
    """Light that leaves one bucket goes to the other, so their gradients differ in sign only."""
    encoder = encoder_of("e")
    light = torch.full((1, 6, 3, 2), 500.0)
    sensor = SensorModel(full_well_e=30000.0, electrons_per_lsb=30000 / 255)
    slopes = []
    for bucket in range(2):
        exposure = differentiable_capture(light, encoder, sensor).exposure_e
        (slope,) = torch.autograd.grad(exposure[:, bucket].sum(), encoder.parameters())
        slopes.append(slope)
    assert (slopes[0] > 0).all()
    assert torch.equal(slopes[0], -slopes[1])


@pytest.mark.parametrize("name", [name for name, each in DECODERS.items() if each.two_buckets])
def test_decoders_of_two_buckets_use_the_frames_of_both(name: str) -> None:
    torch.manual_seed(2)
    decoder = make_decoder(name, "small", DecoderTask("clip", 8, (4, 4), buckets=2)).eval()
    shutters = (torch.rand(8, 4, 4) < 0.5).float()
    frame = torch.rand(1, 2, 16, 16) / 2
    with torch.no_grad():
        made = decoder(frame, shutters)
        assert made.shape == (1, 8, 16, 16)
        for bucket in range(2):
            other = frame.clone()
            other[:, bucket] *= 0.5
            assert not torch.allclose(decoder(other, shutters), made, atol=1e-4)
        # Which of the two comes first is a name.
        if name == "any":
            turned = decoder(frame.flip(1), 1 - shutters)
            assert torch.allclose(turned, made, atol=1e-4)


def test_decoders_of_one_bucket_refuse_two() -> None:
    for name in (name for name, each in DECODERS.items() if each.clips and not each.two_buckets):
        with pytest.raises(ValueError, match="accepts one bucket; unet2d, unet3d, any accept two"):
            make_decoder(name, "small", DecoderTask("clip", 4, (2, 2), buckets=2))


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        (("shutter.class=a",), "class a leaves no light"),
        (("data.protocol=hdr-v1", "shutter.class=b"), "two buckets need clips"),
        (("sensor.effects=all",), "leave out `effects`; `nscc evaluate RUN --effects all`"),
        (("decoder.name=fcnet",), "accepts one bucket"),
        (("shutter.buckets=3",), "shutter.buckets"),
    ],
)
def test_settings_that_exclude_two_buckets_are_refused(changes: tuple[str, ...], said: str) -> None:
    values = {"shutter": SMALL, "data": {"protocol": "two-bucket-v1"}}
    with pytest.raises(Rejected) as caught:
        make_setup(settings_of(values, changes))
    assert "NS0815" in str(caught.value)
    assert said in str(caught.value)


def test_a_run_learns_exposes_and_decodes(tmp_path: Path) -> None:
    shutter = {**SMALL, "relaxation": "tried", "noise": 0.5}
    path = trained(tmp_path / "r", shutter=shutter, data={"protocol": "two-bucket-v1"})
    run = load_run(path)
    stages = run.result["stages"]
    assert stages["compiled_equals_hard"]
    assert stages["emulated"] == pytest.approx(stages["hard"], abs=1e-6)
    light = np.full((4, run.program.target.rows, run.program.target.cols), 900.0, np.float32)
    taken = capture(run.program, light, effects="none")
    made = run.reconstruct(taken)
    assert made.shape == light.shape
    assert np.array_equal(run.reconstruct(taken.frame), made)
    # The truth has no pattern, and neither bucket's code is seen in it.
    assert np.allclose(made.mean(axis=(1, 2)), 900, rtol=0.2)
    with pytest.raises(Rejected, match="two buckets"):
        decoder_points([run.folder], DecoderStudySettings(path, count=1, size=32))
    with pytest.raises(WrongArgument, match=r"its codes \(2, 176, 280\)"):
        run.reconstruct(taken.frame[0])
