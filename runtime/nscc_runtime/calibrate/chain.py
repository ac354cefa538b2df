"""What a program does to the numbers of a chip on their way into a frame."""

from __future__ import annotations

from dataclasses import dataclass

from nscc.words.container import Container


@dataclass(frozen=True)
class Chain:
    """How often the noise of one part reaches an exposure.

    `reads` and `resets`: of PIX, each weighted with its squared coefficient; `word_sum`: the signed
    sum of the coefficients of all analog words, with which errors common to all words add up.
    The default is a chain of one read and one word: figures of the sensor are those of a frame.
    """

    reads: float = 1.0
    resets: float = 1.0
    word_sum: float = 1.0

    @classmethod
    def of(cls, container: Container) -> Chain:
        """The chain of a program that opens all its pixels alike, found from its words.

        Means over the codes in use. Raises Rejected as `nscc_runtime.reference.trace.analog_words`.
        """
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
