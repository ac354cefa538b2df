"""What a loader has been sent of a program: announced, declared, received, checked."""

from __future__ import annotations

from dataclasses import dataclass, field
from hashlib import sha256

from loader_twin.parsing import Held, Limits, Refusal
from nscc.chips.target import Target
from nscc_runtime.device.messages import DATA, Begin, Declare, LoaderFault, LoaderState, ObjectEntry
from nscc_runtime.device.objects import program_digest, target_digest
from nscc_runtime.device.packets import MOST_DATA

MOST_OBJECTS = 64


@dataclass
class Program:
    """The program that was announced, and how much of it is here."""

    begin: Begin
    entries: list[ObjectEntry] = field(default_factory=list)
    held: Held = field(default_factory=Held)
    position: int = 0
    object: int = 0
    part: bytearray = field(default_factory=bytearray)
    failures: int = 0


class Intake:
    """Takes a program in, object by object. All requests raise Refusal; none of them changes
    anything when it is repeated."""

    def __init__(self, target: Target, limits: Limits) -> None:
        self.target, self.limits = target, limits
        self.digest = target_digest(target)
        self.forget()

    def forget(self) -> None:
        """Go back to EMPTY."""
        self.state = LoaderState.EMPTY
        self.program: Program | None = None
        self.refusal: Refusal | None = None

    def announced(self) -> Program:
        """The program of which something may be asked."""
        if self.program is None:
            raise Refusal(LoaderFault.NO_PROGRAM)
        if self.refusal is not None:
            raise Refusal(self.refusal.fault, self.refusal.detail)
        return self.program

    def begin(self, begin: Begin, exposing: bool) -> bool:
        """BEGIN; whether the program is another one than before."""
        if self.program is not None and self.program.begin == begin:
            self.announced()
            return False
        if exposing:
            raise Refusal(LoaderFault.BUSY)
        if begin.target != self.digest:
            raise Refusal(LoaderFault.TARGET)
        if begin.objects > MOST_OBJECTS:
            raise Refusal(LoaderFault.TOO_LARGE, begin.objects)
        self.forget()
        self.state = LoaderState.RECEIVING
        self.program = Program(begin)
        return True

    def declare(self, declare: Declare) -> None:
        """DECLARE: what is known already may be said again, and nothing else."""
        program = self.announced()
        known = len(program.entries)
        repeated = program.entries[declare.first : declare.first + len(declare.entries)]
        said, fresh = declare.entries[: len(repeated)], declare.entries[len(repeated) :]
        too_many = known + len(fresh) > program.begin.objects
        if declare.first > known or repeated != list(said) or too_many:
            raise Refusal(LoaderFault.WRONG_STATE, known)
        for entry in fresh:
            Held.check_room(entry.kind, entry.length, self.target, self.limits)
        program.entries += fresh
        if fresh and len(program.entries) == program.begin.objects:
            begin = program.begin
            packed = b"".join(entry.pack() for entry in program.entries)
            whole = program_digest(begin.target, begin.label, packed)
            total = sum(entry.length for entry in program.entries)
            if whole != begin.program or total != begin.length:
                self._refuse(Refusal(LoaderFault.DIGEST))
            self._commit_empty(program)

    def _refuse(self, refusal: Refusal) -> None:
        """Refuse the program, now and until another is announced."""
        self.state, self.refusal = LoaderState.REFUSED, refusal
        raise refusal

    def data(self, body: bytes) -> None:
        """DATA: taken only where it is waited for."""
        program = self.announced()
        if len(body) < DATA.size or len(body) > DATA.size + MOST_DATA:
            raise Refusal(LoaderFault.MALFORMED)
        (position,) = DATA.unpack_from(body)
        if len(program.entries) < program.begin.objects:
            raise Refusal(LoaderFault.WRONG_STATE, len(program.entries))
        if self.state == LoaderState.RECEIVING and position == program.position:
            self._take(program, body[DATA.size :])

    def _take(self, program: Program, data: bytes) -> None:
        while data and program.object < len(program.entries):
            entry = program.entries[program.object]
            some = data[: entry.length - len(program.part)]
            program.part += some
            program.position += len(some)
            data = data[len(some) :]
            if len(program.part) == entry.length and not self._commit(program):
                return

    def _commit_empty(self, program: Program) -> None:
        """Objects without bytes are whole as soon as they are declared."""
        while program.object < len(program.entries) and not program.entries[program.object].length:
            if not self._commit(program):
                self._refuse(Refusal(LoaderFault.DIGEST))

    def _commit(self, program: Program) -> bool:
        """Accept the object that is whole now; False where its bytes must come again."""
        entry = program.entries[program.object]
        data = bytes(program.part)
        program.part.clear()
        if sha256(data).digest() != entry.sha256:
            program.position -= len(data)
            program.failures += 1
            return False
        try:
            program.held.accept(entry.kind, entry.register, data, self.target, self.limits)
        except Refusal as refusal:
            self._refuse(refusal)
        program.object += 1
        if program.object == len(program.entries):
            try:
                program.held.check_whole(self.target)
            except Refusal as refusal:
                self._refuse(refusal)
            self.state = LoaderState.COMPLETE
        else:
            self._commit_empty(program)
        return True

    def finish(self, digest: bytes) -> None:
        """FINISH: the program is ready if all of it is here."""
        program = self.announced()
        if digest != program.begin.program:
            raise Refusal(LoaderFault.DIGEST)
        if self.state == LoaderState.RECEIVING:
            raise Refusal(LoaderFault.WRONG_STATE, program.position)
        self.state = LoaderState.READY
