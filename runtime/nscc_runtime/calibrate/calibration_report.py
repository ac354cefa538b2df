"""Outputs of a calibration: the sensor file, JSON, a table, and messages."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict

from nscc.columns import columns
from nscc.diagnostics.diagnostic import Diagnostic, Severity
from nscc.mappings import JsonObject
from nscc_runtime.calibrate.estimate import Calibration, Quantity
from nscc_runtime.calibrate.levels import LevelMoments
from nscc_runtime.calibrate.sensor_parameters import ParameterChoice, sensor_of
from nscc_runtime.sensor import sensor_toml

SCHEMA = "nscc-calibration-1"
_BENT = 0.01
"""Relative deviation of levels from the fitted line above which the message is a warning."""


def as_toml(calibration: Calibration, chosen: Mapping[str, ParameterChoice]) -> str:
    """Return a complete sensor file of the `chosen` parameters, by name, as text. A comment gives
    the standard error of each value or its source; the first lines say how `calibration` was
    made."""
    flats, darks = calibration.flats, calibration.darks
    linear = calibration.quantities["linearity_error"]
    heading = [
        f"Calibrated by photon transfer (EMVA 1288) from {sum(m.frames for m in flats)} flats of "
        f"{len(flats)} levels and {sum(m.frames for m in darks)} darks of {len(darks)}, "
        f"{calibration.shape[0]} x {calibration.shape[1]} pixels, "
        f"{calibration.defects} of them left out as defects.",
        f"linearity error: not measured: {linear.remark}"
        if linear.value is None
        else f"linearity error: {linear.value:.3g} +- {linear.se:.2g} %",
    ]
    sources = {name: _source(choice) for name, choice in chosen.items()}
    return sensor_toml(sensor_of(chosen), sources, heading)


def _source(choice: ParameterChoice) -> str:
    """Return where the value of the parameter `choice` comes from, as text: for a measured one its
    value, standard error and remark, else the remark."""
    if choice.status == "measured" and choice.se is not None:
        return f"measured {choice.value:.6g} +- {choice.se:.2g}: {choice.remark}"
    return f"measured: {choice.remark}" if choice.status == "measured" else choice.remark


def as_json(calibration: Calibration, chosen: Mapping[str, ParameterChoice]) -> str:
    """Return the calibration and the `chosen` parameters, by name, as JSON. It has the key
    `schema`, counts, the fit, quantities, parameters, and the points of the photon transfer curve
    (`flats`, `darks`)."""
    curve = calibration.curve
    # By identity, because two levels may have equal moments.
    reasons = {id(level): reason for level, reason in curve.left_out}

    def points(levels: tuple[LevelMoments, ...]) -> list[JsonObject]:
        """Return the moments of each of these `levels` as JSON values. `used` says whether the fit
        used the level; `left_out` is the reason if it did not, None if it did or was not judged."""
        return [
            {
                "exposure_s": level.exposure_s,
                "frames": level.frames,
                "mean_lsb": level.mean,
                "variance_lsb2": level.variance,
                "neighbour_covariance_lsb2": level.neighbours,
                "share_at_zero": level.share_at_zero,
                "share_at_top": level.share_at_top,
                "used": level in curve.used,
                "left_out": reasons.get(id(level)),
            }
            for level in levels
        ]

    def plain(value: Quantity | ParameterChoice) -> JsonObject:
        """Return the fields of `value` as JSON values; its `se` is named "standard_error"."""
        return {
            "standard_error" if k == "se" else k: field_value
            for k, field_value in asdict(value).items()
        }

    return json.dumps(
        {
            "schema": SCHEMA,
            "frames": calibration.frames,
            "pixels": calibration.pixels,
            "defects": calibration.defects,
            "quantities": {name: plain(figure) for name, figure in calibration.quantities.items()},
            "fit": {
                "chi2": curve.fit.misfit,
                "degrees_of_freedom": curve.fit.freedom,
                "probability": curve.fit.chance,
            },
            "parameters": {name: plain(figure) for name, figure in chosen.items()},
            "flats": points(calibration.flats),
            "darks": points(calibration.darks),
        },
        indent=2,
        allow_nan=False,
    )


def as_table(calibration: Calibration) -> str:
    """Return a table with one row for each measured quantity: its title, its value with its
    standard error, and a remark."""
    rows = []
    for q in calibration.quantities.values():
        error = "" if q.se is None else f" +- {q.se:.2g}"
        bound = "" if q.known == "measured" else f"{q.known} "
        value = "not measured"
        if q.value is not None:
            value = f"{bound}{q.value:.6g}{error} {q.unit if q.unit != '1' else ''}".rstrip()
        rows.append((q.title, value, q.remark))
    return columns(rows)


def messages(calibration: Calibration) -> list[Diagnostic]:
    """Return diagnostics of a calibration: a note (NS0791) on unknown quantities, and one (NS0792)
    if levels deviate from the fitted line, a warning above 1 %. The list is empty if all is
    well."""
    diagnostics: list[Diagnostic] = []
    unknown: dict[str, list[str]] = {}
    for quantity in calibration.quantities.values():
        if quantity.value is None:
            unknown.setdefault(quantity.remark, []).append(quantity.title)
    if unknown:
        count = sum(len(titles) for titles in unknown.values())
        diagnostics.append(
            Diagnostic(
                "NS0791",
                f"these frames do not determine {count} of "
                f"{len(calibration.quantities)} parameters",
                severity=Severity.NOTE,
                notes=tuple(
                    f"{', '.join(dict.fromkeys(titles))}: {why}" for why, titles in unknown.items()
                ),
                helps=("the sensor file contains the defaults for them and marks them",),
                data={"open": [n for n, q in calibration.quantities.items() if q.value is None]},
            )
        )
    fit = calibration.curve.fit
    # `excess` is 1 unless the deviation is improbable.
    if fit.excess > 1:
        bent = fit.apart > _BENT
        diagnostics.append(
            Diagnostic(
                "NS0792",
                "the noise is not a linear function of the mean: levels deviate by "
                f"{fit.apart:.2%}, {fit.excess**0.5:.2g} times their errors",
                severity=Severity.WARNING if bent else Severity.NOTE,
                notes=(
                    f"chi squared is {fit.misfit:.3g} for {fit.freedom} degrees of freedom; "
                    "the errors of gain and noise were increased by that factor",
                    "levels near saturation, light that flickers within a frame, memories that "
                    "leak and noise that grows with the signal bend the line",
                ),
                helps=("check the levels with --json, and leave out levels that deviate",)
                if bent
                else (),
            )
        )
    return diagnostics
