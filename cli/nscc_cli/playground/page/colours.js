// The colours of a program's text, with the places of messages underlined.

// The offset in UTF-16 units of a place, whose row and column count characters from 1.
export function offsetOf(text, { row, column }) {
  const lines = text.split("\n");
  const before = lines.slice(0, row - 1).reduce((sum, line) => sum + line.length + 1, 0);
  return before + [...(lines[row - 1] ?? "")].slice(0, column - 1).join("").length;
}

export function coloured(text, words, messages) {
  const version = text.match(/^\s*nsl\s+(\d+)/m)?.[1];
  const [statements, all] = words[version] ?? words[1];
  const kinds = [
    ["remark", "#.*"],
    ["text", '"[^"\\n]*"?'],
    ["number", "\\b\\d[\\w.]*"],
    ["statement", `\\b(?:${statements.join("|")})\\b`],
    ["word", `\\b(?:${all.join("|")})\\b`],
  ];
  const pattern = new RegExp(kinds.map(([kind, form]) => `(?<${kind}>${form})`).join("|"), "g");
  const cuts = new Set([0, text.length]);
  const spans = [];
  for (const match of text.matchAll(pattern)) {
    const kind = Object.keys(match.groups).find((name) => match.groups[name] !== undefined);
    spans.push([match.index, match.index + match[0].length, kind]);
  }
  for (const { location, end_location: end, severity } of messages) {
    if (!location) continue;
    const from = offsetOf(text, location);
    spans.push([from, Math.max(from + 1, offsetOf(text, end)), severity]);
  }
  for (const [from, to] of spans) cuts.add(from).add(Math.min(to, text.length));
  const places = [...cuts].sort((a, b) => a - b);
  const pieces = places.slice(0, -1).map((from, k) => {
    const piece = document.createElement("span");
    piece.textContent = text.slice(from, places[k + 1]);
    piece.className = spans.filter(([a, b]) => a <= from && from < b).map(([, , kind]) => kind).join(" ");
    return piece;
  });
  return [...pieces, "\n"];
}
