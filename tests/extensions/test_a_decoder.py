"""Recipe: a decoder of another distribution's, by name, through training and reconstruction."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from added_package import add_package, nscc_with

pytest.importorskip("torch")

SOURCE = '''
import torch


class Shine(torch.nn.Module):
    """Stills: the frame over the part of the slots that each pixel was open for, times a gain."""

    def __init__(self, *, size, kind, slots, tile, sees_code):
        super().__init__()
        self.gain = torch.nn.Parameter(torch.ones(()))

    def forward(self, frame, shutters):
        rows, cols = frame.shape[-2:]
        down, across = -(-rows // shutters.shape[1]), -(-cols // shutters.shape[2])
        open_part = shutters.mean(dim=0).repeat(down, across)[:rows, :cols]
        return self.gain * frame / open_part.clamp(min=0.01)


text = "no decoder"
'''
SMALL = (
    "shutter.slots=8",
    "shutter.tile=[2,2]",
    "data.patch=16",
    "data.scenes=2",
    "data.val_items=1",
    "train.steps=2",
    "train.batch=1",
    "decoder.name=shine",
)


def test_a_decoder_of_another_package_is_trained_and_decodes_frames(tmp_path: Path) -> None:
    add_package(tmp_path, SOURCE, "nscc.decoders", "shine", "Shine")
    (tmp_path / "c.toml").write_text(nscc_with(tmp_path, "train", "--schema").stdout)
    choices = [word for pair in SMALL for word in ("--set", pair)]
    trained = nscc_with(tmp_path, "train", "c.toml", "--out", "run", *choices)
    assert trained.returncode == 0, trained.stderr
    exposed = nscc_with(tmp_path, "run", "run/shutter.nsl", "--scene", "builtin:hdr", "-o", "f.npz")
    assert exposed.returncode == 0, exposed.stderr
    made = nscc_with(tmp_path, "reconstruct", "run", "f.npz", "-o", "r.npz", "--force")
    assert made.returncode == 0, made.stderr
    image = np.load(tmp_path / "r.npz")["image"]
    assert image.shape == (256, 256) and np.isfinite(image).all()  # noqa: PT018


@pytest.mark.parametrize(("name", "value"), [("shine", "text"), ("unet2d", "Shine")])
def test_invalid_decoders_and_taken_names_are_refused(
    tmp_path: Path, name: str, value: str
) -> None:
    add_package(tmp_path, SOURCE, "nscc.decoders", name, value)
    (tmp_path / "c.toml").write_text("[shutter]\nslots = 8\n")
    done = nscc_with(tmp_path, "train", "c.toml", "--out", "run", "--set", "decoder.name=shine")
    assert done.returncode == 2
    assert f"[NS0905]: the decoder '{name}'" in done.stderr
