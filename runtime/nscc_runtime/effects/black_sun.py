"""Light that lowers the reset level: the black sun."""

from __future__ import annotations

from nscc_runtime.effects.effect import Effect, InLoop, Mark
from nscc_runtime.effects.full_well import FULL
from nscc_runtime.effects.parts import LitLevel

BLACK_SUN = Effect(
    name="black_sun",
    stream=20,
    kind="fixed",
    title="light that eats the level of a reset",
    model="Light goes on falling while words run. A word that reads the level of PIX after a reset "
    "at the same boundary finds what has fallen since the reset, up to a full well, and it is "
    "subtracted: the brightest lights turn dark. Without `dead_time` words take no time.",
    cost="none beside `dead_time`",
    applied="to PIX as a source, at the boundary of its reset",
    absent="no word reads the level of a reset at its boundary, or there is no charge",
    parameters=(FULL,),
    reference={"level": lambda _pixels, charge, _word: charge},
    size="rms and mean of what falls between a reset and the word that reads its level, which "
    "is subtracted; at most a full well",
    sums=(LitLevel(),),
    words=InLoop("lit_level"),
    marks={"level": Mark(bit=16, name="black sun")},
)
