"""The factors with which a program's words scale the noise of a chip in a frame."""

from __future__ import annotations

from dataclasses import dataclass

from nscc.words.container import Container


@dataclass(frozen=True)
class Chain:
    """The factors with which noise sources of the chip appear in an exposure.

    `reads`, `resets`: numbers of reads and resets of PIX, each weighted with its squared
    coefficient. `word_sum`: signed sum of the coefficients of all analog words, which scales errors
    common to all words. The default is one read and one word: sensor values then equal those of a
    frame."""

    reads: float = 1.0
    resets: float = 1.0
    word_sum: float = 1.0

    @classmethod
    def of(cls, container: Container) -> Chain:
        """Compute the factors of a program from its words, as the mean over the codes in use.

        The program must open all pixels alike. Raises Rejected like
        `nscc_runtime.reference.trace.analog_words`."""
        import numpy as np

        from nscc_runtime.reference.trace import analog_words
        from nscc_runtime.reference.weights import backward

        weights = backward(container, analog_words(container))
        lanes = np.arange(len(container.encoding))
        if container.pixel_codes is not None:
            lanes = np.unique(container.table.shutter_of_code[container.pixel_codes])

        reads, resets = weights.squared("reads"), weights.squared("resets")
        sums = (reads, resets, weights.error_sum)
        return cls(*(float(per_shutter[lanes, 0].mean()) for per_shutter in sums))
