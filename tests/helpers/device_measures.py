"""What `bench_device.py` measures: sessions over bad cables, and what a good line takes.

Half of the sessions go to the Python twin, half to the firmware's core with sanitizers (all to the
twin where there is no compiler). All of it is on a virtual clock, except where it says otherwise.
"""

from __future__ import annotations

import gc
import os
import sys
import tempfile
from collections import Counter
from dataclasses import replace
from pathlib import Path
from time import perf_counter

from device_lockstep import SANITIZERS, Lockstep
from device_sessions import (
    TARGET,
    Example,
    chip_of,
    examples,
    new_host,
    python_loader,
    session,
)
from device_simulation import Hung, Simulation
from emulator_programs import container_of, target_of
from loader_twin.loader import Loader

from nscc.operations import op
from nscc_runtime.device import firmware, tasks
from nscc_runtime.device.firmware import RunningFirmware
from nscc_runtime.device.host import Silent, Stalled
from nscc_runtime.device.objects import Upload, upload_of
from nscc_runtime.device.serving import LineFaults

SESSIONS = 10_000
LIMIT_LINE_S = 0.50
LIMIT_RESUME_S = 2.0
BAUD = 3e6


def open_files() -> int:
    """How many file descriptors this process has open."""
    return len(os.listdir("/dev/fd"))


def outcome(seed: int, core: Lockstep | None) -> str:
    """How one session ended."""

    def started(example: Example) -> RunningFirmware:
        if core is None:
            return python_loader(example)
        core.chip = chip_of(example)
        core.announce()
        return core

    try:
        right, _ = session(seed, started)
    except Hung:
        return "hung"
    except (Silent, Stalled):
        return "gave up"
    return "right" if right else "WRONG"


def sessions(count: int) -> bool:
    """Runs the sessions and prints how they ended; whether all is well."""
    core = None
    with tempfile.TemporaryDirectory() as folder:
        if firmware.compiler() is not None:
            built = firmware.built(TARGET, ("-O1", *SANITIZERS), Path(folder))
            core = Lockstep(built, chip_of(examples()[0]))
        found: Counter[str] = Counter()
        begin = perf_counter()
        files = objects = 0
        for seed in range(count):
            # Caches fill up in the first sessions; from then on nothing may grow.
            if seed == min(100, count // 2):
                gc.collect()
                files, objects = open_files(), len(gc.get_objects())
            found[outcome(seed, core if seed % 2 else None)] += 1
        took_s = perf_counter() - begin
        gc.collect()
        leaked = open_files() - files, len(gc.get_objects()) - objects
        status = core.close() if core else 0
    listed = ", ".join(f"{number} {what}" for what, number in sorted(found.items()))
    print(f"{count} sessions ({'firmware and ' if core else ''}Python): {listed}; {took_s:.0f} s")
    print(f"leaks: {leaked[0]} files, {leaked[1]} objects, sanitizers' status {status}")
    # A few objects more or less are the interpreter's own.
    clean = leaked[0] <= 0 and leaked[1] < 100 and status == 0
    return clean and found["WRONG"] == found["hung"] == 0


def large_upload() -> Upload:
    """1024 words and 13 planes of arbitrary codes."""
    import numpy as np

    target = target_of((256, 256))
    numbers = np.random.default_rng(0)
    planes = {name: numbers.random((256, 256)) < 0.5 for name in target.digital_registers}
    kernels = [[op("NOR", ["R1"], ["R2", "R3"])] * 4 for _ in range(256)]
    container = container_of(target, planes, kernels, [(n, n) for n in range(256)], 256)
    container = replace(container, slot_us=(100.0,) * 256)
    return upload_of(container, bytes(32))


def upload_s(upload: Upload, faults: LineFaults) -> float:
    """How long the upload takes at 3 Mbit/s."""
    host = new_host(1)
    loader = Loader(target_of((256, 256)), chip_of(examples()[0]), "bench")
    line = Simulation(host, loader, faults, baud=BAUD)
    line.run(host.lasting(lambda: tasks.upload(host, upload)))
    return line.now


def good_line() -> bool:
    """Prints what an upload takes beside the bytes alone, and after a lost link."""
    upload = large_upload()
    bytes_s = len(upload.stream) * 10 / BAUD
    well = True
    for delay_ms in (0, 1, 4):
        took = upload_s(upload, LineFaults(delay_s=delay_ms / 1000))
        over = "" if took <= LIMIT_LINE_S or delay_ms > 1 else "  OVER"
        well = well and not over
        print(
            f"upload of {len(upload.stream)} bytes, {delay_ms} ms either way: {took:.3f} s, "
            f"{took / bytes_s:.3f} of the bytes alone{over}"
        )
    for after in (10_000, 60_000, 120_000):
        outage_s = 1.0
        took = upload_s(upload, LineFaults(disconnect_after=after, outage_s=outage_s))
        unsent_s = (len(upload.stream) - after) * 10 / BAUD
        extra = took - after * 10 / BAUD - outage_s - unsent_s
        over = "" if extra <= LIMIT_RESUME_S else "  OVER"
        well = well and not over
        print(f"link lost after {after} bytes: {extra:.3f} s beside what was not yet sent{over}")
    return well


def main() -> int:
    """Prints all of it; 1 where something is not as it has to be."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else SESSIONS
    well = good_line()
    well = sessions(count) and well
    return 0 if well else 1
