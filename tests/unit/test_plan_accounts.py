"""What errors make together, beside the same pixel by pixel."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from nscc_runtime.planner.accounts import Account
from nscc_runtime.planner.sample import Sample

FIXED, RANDOM, SKEWED = ("a", "b", "c"), ("b", "c", "d"), ("c", "d")
BUCKETS, PIXELS = 2, 40


@pytest.fixture(scope="module")
def account() -> Account:
    rng = np.random.default_rng(4)
    weight = rng.exponential(9.0, PIXELS)
    sample = Sample(np.arange(PIXELS), weight, np.zeros(PIXELS, np.bool_))
    fixed = {name: rng.normal(1.0, 5.0, (BUCKETS, PIXELS)) for name in FIXED}
    random = {name: rng.exponential(3.0, (BUCKETS, PIXELS)) for name in RANDOM}
    skewed = {name: 0.5 * random[name] for name in SKEWED}
    return Account(sample, BUCKETS, fixed, random, skewed)


def chosen(names: tuple[str, ...]) -> list[set[str]]:
    return [{*some} for n in range(len(names) + 1) for some in itertools.combinations(names, n)]


@pytest.mark.parametrize("random", chosen(RANDOM))
@pytest.mark.parametrize("fixed", chosen(FIXED))
def test_some_errors_together_are_those_of_each_pixel(
    account: Account, fixed: set[str], random: set[str]
) -> None:
    weight = account.sample.weight
    for bucket in range(BUCKETS):
        mean = sum((account.fixed[name][bucket] for name in fixed), np.zeros(PIXELS))
        variance = sum((account.random[name][bucket] for name in random), np.zeros(PIXELS))
        found = [each[bucket] for each in account.errors(fixed, random)]
        assert found[0] == pytest.approx(mean)
        assert found[1] == pytest.approx(variance)
        third = sum((account.skewed[n][bucket] for n in random & {*SKEWED}), np.zeros(PIXELS))
        assert found[2] == pytest.approx(third)
        # A name of the one kind that is not of the other changes nothing.
        square = account.square(fixed | {"d", "none"}, random | {"a"})[bucket]
        assert square == pytest.approx(np.average(mean**2 + variance, weights=weight))
        sizes = [np.sqrt(np.average(account.fixed[n][bucket] ** 2, weights=weight)) for n in fixed]
        most = sum(sizes) ** 2 + np.average(variance, weights=weight)
        assert account.most(fixed, random)[bucket] == pytest.approx(most)


@pytest.mark.parametrize("name", ["a", "b", "d", "none"])
def test_an_effect_has_its_own_square_and_mean(account: Account, name: str) -> None:
    weight, none = account.sample.weight, np.zeros((BUCKETS, PIXELS))
    field, variance = account.fixed.get(name, none), account.random.get(name, none)
    square, bias = account.own(name)
    assert square == pytest.approx(np.average(field**2 + variance, axis=1, weights=weight))
    assert bias == pytest.approx(np.average(field, axis=1, weights=weight))


def test_no_errors_at_all_are_nothing(account: Account) -> None:
    empty = Account(account.sample, BUCKETS, {}, {})
    assert (empty.square({"a"}, {"b"}) == 0.0).all()
    assert all((each == 0.0).all() for each in empty.errors({"a"}, {"b"}))
