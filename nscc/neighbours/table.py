"""Short programs of one input, as text: found by a search (`docs/kernel_programs.py`) or by hand.

`nscc.neighbours.programs.program_from_text` reads them. A row does not state its convolution
kernel: `kernel_of` computes it from the words."""

from __future__ import annotations

from nscc.chips.target import Target
from nscc.neighbours.programs import BusWord, Program
from nscc.operations import NEIGHBOURS
from nscc.record import Record


class WordForms(Record):
    """The words with neighbours that a chip allows.

    `sources` is the most sources of a word that reads or writes a neighbour. `halving` tells
    whether a word that reads a neighbour may halve, `news_keeps` whether NEWS (the register that
    neighbours can read) keeps its value when a neighbour reads it."""

    sources: int = 2
    halving: bool = False
    news_keeps: bool = True

    @classmethod
    def choices(cls, target: Target) -> list[WordForms]:
        """Return the sets of word forms to try on a target: all that it has, then, if these are
        more, those that are published of scamp5.

        A convolution kernel in fewer forms may leave more values in registers, which the next
        kernels can use."""
        keeps = target.news_read_keeps
        forms = cls(target.directed_sources, target.directed_halving, keeps)
        public = cls(min(cls.sources, forms.sources), news_keeps=keeps)
        return [forms] if forms == public else [forms, public]

    def allow(self, word: BusWord) -> bool:
        """Return whether the chip has a word of this form; it has every word that reaches no
        neighbour."""
        if NEIGHBOURS.keys().isdisjoint((*word.sources, *word.destinations)):
            return True
        return len(word.sources) <= self.sources and (self.halving or not word.halves)

    def allowed(self, program: Program) -> Program:
        """Return an equal program of words that the chip allows.

        A word that reads or writes a neighbour, and halves or has more sources than the chip
        allows, becomes three. The first two copy the sum of the neighbours that it reads, or of all
        its sources if it reads none, to a register, which the third reads instead."""
        words: list[BusWord] = []
        for number, word in enumerate(program):
            if self.allow(word):
                words.append(word)
                continue
            inverted, copy = f"{number}i", f"{number}c"
            neighbours = tuple(name for name in word.sources if name in NEIGHBOURS)
            own_registers = tuple(
                name for name in word.sources if neighbours and name not in NEIGHBOURS
            )
            words.append(BusWord((inverted,), neighbours or word.sources))
            words.append(BusWord((copy,), (inverted,)))
            words.append(BusWord(word.destinations, (*own_registers, copy)))
        return tuple(words)


ROWS = """
a=x n=a b=E c=W d=x,n e=a,d n=a,b,c f=a,d,N g=b,c,e,f h=d,g,S
n=x a=x b=n,a
n=x a=n b=x,a
n=x a=x b=x c=n,a,b
n=x a=n b=n c=x,a,b
n=x a=x b=x c=x d=n,a,b,c
n=x a=n b=n c=n d=x,a,b,c
n=x a=n b=x,a c=x,a d=n,b,c
n=x a=n b=x,a c=n,b d=x,a,c
n=x a=E b=a,n
n=x a=E b=a,W
n=x a=E b=a c=b,W
W=x a=S b=a,W
n=x a=E b=x,a c=b,W
W=x a2=x,n bn=x,a c=b,W
n=x a=E b=x,W c=a,b,n
n=x a=E b=W c=x,a,b d=c,n
n=x a=E b=W c=x,a,b
n=x a=N bn=x,a c2=b,E d2=b,W en=c,d f2=e,S
a=x S=a b=E cn=a,b d=S e=W f2=d,e
S=x a=E bn=x,a c=S d=c e=d,W
an=x b=a,N c=a,S dn=b,c e=E f2=e,W
n=x a=N b=E c2=a,b N=a,b,c d2=c,W
an=x b=N c=E d=a,S e=b,c,d f2=e,W
an=x b=N c=E d=S e=W f=b,c,d,e g2=f,n
n=x a=N b=S n=x,a,b c=E d=x,a,b,c e=d,W
n=x a=E b=x,a n=x,a c=b,S
n=x a=N b=S n=x,a,b c=E d=c,W
n=x a=N b=x c=b,S n=x,a,c d=E e=d,W
n=x a=N b=E c=x,a,b N=a,b d=c,W
n=x a=E b=W n=x,a,b c=N d=S e=a,b,c,d
n=x a=N b=E c=S d=a,b,c e=d,W
n=x a=x,N b=x,E c=x,S d=x,W e=a,b,c,d
n=x a=x,N b=x,E c=x,S d=a,b,c,n e=d,W
n=x a=N b=x,N c=x,E d=x,W N=a,b e=b,c,d,n
n=x a=N b=S c=x n=x,a,b d=c,E e=a,b,d f=e,W
an=x b=E c=b,W
n=x a=E b2=a,n
W=x a2=x,n E=a b2=a,n
n=x a=x,E b=x,W cn=a,b
an=x b=E c=x,b,n d=c,W
an=x b=E c=b d=c,W
n=x a=E b=a c=b,W
n=x a=E E=x,a b2=a,n c2=b,n
S=x a=E bn=x,a c=x,S d=x,W en=c,d
W=x a=n b=E c=x,a,b E=x,a d=c,W
a=x n=a b=x,E c=x,W n=a,b,c d=x,E e=x,W f=b,c,d,e
n=x a=E b=W c=x,a,b E=c d=W W=c e=x,E f=d,e
n=x a=E b=W c=x,a,b E=c d=W W=c e=x,E f2=d,e
n=x a=x,N b=x,S c=a,b d=x,E e=x,W n=c f=d,E g=e,W h=f,g i=d,e n=c,i j=h,n,d,e
"""
