"""Who imports whom: every import of every file, wherever in the file it stands."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

import networkx as nx


def modules(folder: Path) -> dict[str, Path]:
    """The files below a package's folder by their dotted names; `a/__init__.py` is `a`."""
    found = {}
    for path in sorted(folder.rglob("*.py")):
        parts = (folder.name, *path.relative_to(folder).with_suffix("").parts)
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


def imported(name: str, path: Path) -> Iterator[str]:
    """The dotted names that module `name` imports: deferred imports and those for types, too.

    Of `from a import b` that is `a.b`, which may be a module or something in `a`.
    """
    package = name if path.stem == "__init__" else name.rpartition(".")[0]
    for node in ast.walk(ast.parse(path.read_bytes())):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            above = package.split(".")[: len(package.split(".")) + 1 - node.level]
            base = ".".join([*(above if node.level else []), *filter(None, [node.module])])
            yield from (f"{base}.{alias.name}" for alias in node.names)


def file_graph(files: Mapping[str, Path]) -> nx.DiGraph[str]:
    """An arrow from each module to each other of `files` that it imports.

    That importing `a.b` runs `a` first is no arrow: a package's face shows what is in its rooms.
    """
    graph: nx.DiGraph[str] = nx.DiGraph()
    graph.add_nodes_from(files)
    for name, path in files.items():
        for wanted in imported(name, path):
            found = wanted if wanted in files else wanted.rpartition(".")[0]
            if found in files and found != name:
                graph.add_edge(name, found)
    return graph


def folder_graph(files: nx.DiGraph[str], folder: str) -> nx.DiGraph[str]:
    """The same between what lies in one folder: its files, and its folders with all below them."""
    graph: nx.DiGraph[str] = nx.DiGraph()
    for name, other in files.edges:
        here, there = (_within(each, folder) for each in (name, other))
        if here and there and here != there:
            graph.add_edge(here, there)
    return graph


def _within(name: str, folder: str) -> str:
    """What of `folder` holds module `name`; "" if none does. A package's own face is no room."""
    if not name.startswith(f"{folder}."):
        return ""
    return f"{folder}.{name.removeprefix(f'{folder}.').partition('.')[0]}"


def circles(graph: nx.DiGraph[str]) -> list[list[str]]:
    """Nodes that reach each other, each group in the order of names."""
    groups = nx.strongly_connected_components(graph)
    return sorted(sorted(group) for group in groups if len(group) > 1)


def arrows_up(files: nx.DiGraph[str], floors: Iterable[str]) -> list[str]:
    """Imports from a floor of one above it; `floors` from the ground up."""
    level = {floor: number for number, floor in enumerate(floors)}
    return sorted(
        f"{name} imports {other}"
        for name, other in files.edges
        if level[other.partition(".")[0]] > level[name.partition(".")[0]]
    )
