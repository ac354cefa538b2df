"""Errors of devices as messages with remedies."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from nscc.chips.target import Target
from nscc.diagnostics import diagnostic
from nscc.diagnostics.diagnostic import Rejected
from nscc_runtime.device.host import Contested, Implausible, RequestRefused, Silent, Stalled
from nscc_runtime.device.loaders import MOST_CHANGES, MOST_PARAMS, RESOURCES, shortages
from nscc_runtime.device.messages import Capability, Info, LoaderFault, name_of
from nscc_runtime.device.objects import Upload, target_digest
from nscc_runtime.device.packets import VERSION, PacketKind
from nscc_runtime.device.port import PortTrouble

FAILED = 3
"""Exit status of the command line if a device fails."""
TOO_LONG, NO_BREATH, FADES = 7, 8, 9
"""Details of the fault SCHEDULE: invalid times of a schedule."""
_UNTIMED = {
    TOO_LONG: "their duration exceeds the range of its clock",
    NO_BREATH: "they block its other work for more than two seconds",
    FADES: "a register with a code is not rewritten often enough",
}
_LIST = "`nscc doctor` lists the serial ports of this machine"
_STAND_IN = "`nscc device serve --scene SCENE` starts a simulated device and prints its port"


def rejected(code: str, message: str, *helps: str, **options: Any) -> Rejected:
    """Return a device failure (exit status 3) with an error `code` such as NS0760. `helps` are
    remedies. `options`: notes and data, see `nscc.diagnostics.diagnostic`."""
    return diagnostic.rejected(code, message, helps=helps, status=FAILED, **options)


def port_trouble(port: str, trouble: PortTrouble) -> Rejected:
    """Return the error for a `port` that cannot be opened (NS0760) or is in use (NS0761). `trouble`
    has the kind, which selects the remedies, and the reason."""
    shown = port[:200]
    if trouble.kind == "busy":
        return rejected(
            "NS0761",
            f"the port '{shown}' is busy: {trouble.reason}",
            "end the other program (`fuser PORT` names it), or wait until it ends",
        )
    helps = {
        "missing": (_LIST, _STAND_IN),
        "forbidden": (
            "add your user to the group that owns the port (`ls -l PORT` shows it; often "
            "dialout or uucp), then log in again",
        ),
        "unsuited": (_LIST, _STAND_IN),
        "baud": ("choose another speed: every port supports --baud 115200",),
    }.get(trouble.kind, (_LIST,))
    return rejected("NS0760", f"cannot open the port '{shown}': {trouble.reason}", *helps)


def port_lost(port: str, seconds: float) -> Rejected:
    """Return the error NS0766 for a `port` that was lost and did not return within `seconds`."""
    return rejected(
        "NS0766",
        f"the connection to the device at '{port[:200]}' was lost and did not return within "
        f"{seconds:g} s",
        "check the cable and the power, then run the command again: it does not resend data "
        "that the device has",
        "--patience S waits longer",
    )


@contextmanager
def explained(port: str, patience_s: float) -> Iterator[None]:
    """Convert exceptions of a host's task, in a with block, to Rejected (status 3) about the device
    at `port`. `patience_s`: how long a lost port was waited for. Other exceptions pass."""
    try:
        yield
    except Silent as silent:
        if silent.ever:
            raise port_lost(port, patience_s) from None
        behaviour = "says nothing"
        if silent.noise:
            shown = repr(silent.noise)[1:]
            behaviour = f"sends bytes that are not packets of the loader, beginning with {shown}"
        raise rejected(
            "NS0762",
            f"no nscc loader answers at '{port[:200]}': the device {behaviour}",
            "install the loader on the device (see runtime/firmware/README.md), or name "
            "another port",
            "if the loader is installed, it may use another speed: --baud",
            _LIST,
        ) from None
    except Stalled:
        raise rejected(
            "NS0766",
            f"the device at '{port[:200]}' answers, but the transfer fails",
            "the line is too bad, or the device restarts repeatedly: check the cable, the "
            "speed (--baud) and the power",
        ) from None
    except Contested:
        raise rejected(
            "NS0775",
            f"another program uses the device at '{port[:200]}'",
            "end it, or wait until it ends: a device has one host at a time",
            notes=("the device did not restart, but it started conversations with another host",),
        ) from None
    except Implausible as implausible:
        captured = implausible.captured
        raise rejected(
            "NS0767",
            f"the device at '{port[:200]}' reports a frame of {captured.length} bytes in "
            f"{captured.readouts} buckets, which does not match the program",
            "install the loader that came with this nscc",
        ) from None
    except RequestRefused as refused:
        raise _refused(port, refused) from None


def _refused(port: str, refused: RequestRefused) -> Rejected:
    """Return the error for a request that the device at `port` rejected, with what to do. `refused`
    has the fault and its detail; faults without a text of their own get NS0767, with their
    names."""
    failure = refused.failure
    device = f"the device at '{port[:200]}'"
    match failure.fault:
        case LoaderFault.VERSION:
            return rejected(
                "NS0762",
                f"{device} uses version {failure.detail} of the protocol, but this nscc uses "
                f"version {VERSION}",
                "install the loader that came with this nscc (runtime/firmware)",
            )
        case LoaderFault.HARDWARE:
            return rejected(
                "NS0768",
                f"{device} could not expose a frame",
                "a simulated device prints the reason in its own terminal (for example a "
                "scene that does not fit the program); switch a real chip off and on",
            )
        case LoaderFault.TARGET:
            return rejected(
                "NS0764",
                f"the program was compiled for another chip than {device}",
                "build it for the target of the device: `nscc device info PORT` names the target",
            )
        case LoaderFault.NO_PROGRAM:
            return no_program(port)
        case LoaderFault.LATE:
            return rejected(
                "NS0721",
                f"{device} began {failure.detail} launch{'' if failure.detail == 1 else 'es'} of "
                "the frame later than the program allows",
                "measure the device's times and build the program with them: `nscc device "
                "calibrate PORT`",
            )
        case LoaderFault.SCHEDULE if failure.detail in _UNTIMED:
            return rejected(
                "NS0722",
                f"{device} cannot schedule the frames of the program: {_UNTIMED[failure.detail]}",
                "use fewer slots, or longer ones: one of more than 200 us in every two seconds is "
                "enough",
            )
    # Any other fault means that the loader's rules differ from those of nscc.
    name = name_of(LoaderFault, failure.fault)
    request = name_of(PacketKind, failure.request)
    return rejected(
        "NS0767",
        f"{device} rejects the program or the request: {name.lower().replace('_', ' ')}, "
        f"{failure.detail}, in answer to {request}",
        "build the program again, and install the loader that came with this nscc",
        notes=(
            "nscc checked the program before sending it, so nscc and the loader use different "
            "rules",
        ),
    )


def no_program(port: str) -> Rejected:
    """Return the error (NS0771) that the device at `port` has no program, with how to upload
    one."""
    return rejected(
        "NS0771",
        f"the device at '{port[:200]}' holds no program",
        "upload one: `nscc device upload PORT FILE`, or name it: `nscc device capture PORT FILE`",
    )


def states_lost(port: str) -> Rejected:
    """Return the error (NS0774) that the device at `port` lost the kept states of the previous
    frame."""
    return rejected(
        "NS0774",
        f"the device at '{port[:200]}' lost the kept states of its pixels",
        "run the command again: the frames then start with the program's initial states",
        notes=("the device restarted, or another host uploaded a program, between two frames",),
    )


def wrong_target(port: str, target: Target, info: Info) -> Rejected:
    """Return the error (NS0764) that the program for `target` was compiled for another chip than
    the device at `port`, or for another table of the same chip. `info` describes the device's
    loader."""
    device = f"the device at '{port[:200]}'"
    theirs, ours = info.target_name, target.name
    if theirs != ours:
        return rejected(
            "NS0764",
            f"the program is for {ours}, but {device} is {theirs}",
            f"build it for the target of the device: `--target {theirs}`, or its target file",
        )
    return rejected(
        "NS0764",
        f"the program is for {ours}, but {device} is a {theirs} with another target table",
        "build the program with the target table of the device's loader",
        notes=(
            f"the program's array is {target.rows} x {target.cols}, but the device's is "
            f"{info.rows} x {info.cols}",
        ),
    )


def check_fits(port: str, upload: Upload, target: Target, info: Info, channels: int) -> None:
    """Raise Rejected, before sending, for a program that the loader at `port` would refuse: NS0764
    for another `target`, NS0765 for too little room or a missing capability.

    `upload` is the program in the form that is sent, and `info` describes the loader. `channels`,
    bits of `Channel`, are the parts of a frame that the host wants, which decide its size."""
    if target_digest(target) != info.target:
        raise wrong_target(port, target, info)
    room = {
        "words": info.most_words,
        "kernels": info.most_kernels,
        "rows": info.most_rows,
        "runs": info.most_runs,
        "frame_bytes": info.most_frame,
        "frame_ms": info.longest_ms,
        "params": MOST_PARAMS,
        "changes": MOST_CHANGES,
    }
    for short in shortages(upload.needs(channels), room)[:1]:
        raise rejected(
            "NS0765",
            f"the program does not fit the loader at '{port[:200]}': it needs {short}",
            f"{RESOURCES[short.resource][1]}; the limits are set when the loader is built "
            "(runtime/firmware)",
            data={**short._asdict(), "proved": True},
        )
    looks = upload.levels or upload.states
    for needed, capability, subject in (
        (upload.pictures, Capability.PICTURES, "the program computes images or planes"),
        (looks, Capability.LOOKS, "the program's pixels look at the light"),
        (
            upload.host_values,
            Capability.HOST_VALUES,
            "the program has values that the host sets, or keeps images",
        ),
    ):
        if needed and not info.capabilities & capability:
            raise rejected(
                "NS0765",
                f"{subject}, but the loader at '{port[:200]}' does not support this",
                "install the loader that came with this nscc (runtime/firmware)",
            )
    if upload.gains and not info.capabilities & Capability.GAIN:
        raise rejected(
            "NS0765",
            f"the program scales its readouts, which the loader at '{port[:200]}' does not support",
            "build the program with another --lowering",
        )
