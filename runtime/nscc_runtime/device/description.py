"""The description of a loader as text and as JSON."""

from __future__ import annotations

import json
from dataclasses import asdict

from nscc_runtime.device.messages import Info, LoaderState, Status


def info_text(info: Info, status: Status) -> str:
    """Return a loader's description, one property per line."""
    state = (
        LoaderState(info.state).name.lower() if info.state in set(LoaderState) else str(info.state)
    )
    holds = f"program {info.label.hex()}" if any(info.program) else "no program"
    return "\n".join(
        [
            f"loader     {info.firmware}, protocol {info.version}",
            f"target     {info.target_name}, {info.rows} x {info.cols} pixels, "
            f"table {info.target.hex()[:16]}",
            f"holds      {holds} ({state})",
            f"room       {info.most_words} words, {info.most_kernels} kernels, "
            f"{info.most_rows} rows of schedule, {info.most_frame} bytes of frame",
            f"line       {info.window} bytes ahead, {info.most_data} a packet; "
            f"{status.packets} packets received, {status.damaged} damaged",
            f"up         {status.uptime_us / 1e6:.1f} s",
            "",
        ]
    )


def info_json(info: Info, status: Status) -> str:
    """Return a loader's description as JSON, with digests in hexadecimal."""
    values = {**asdict(info), "status": asdict(status)}
    for name in ("target", "program", "label"):
        values[name] = values[name].hex()
    return json.dumps(values, indent=2) + "\n"
