// Links that hold a program: JSON, compressed (raw deflate), in the letters of URLs.

const through = async (data, stream) =>
  new Uint8Array(await new Response(new Blob([data]).stream().pipeThrough(stream)).arrayBuffer());

// The part of an address from # on. `values`: program, scene and exposure.
export async function linkOf(values) {
  const data = await through(new TextEncoder().encode(JSON.stringify(values)), new CompressionStream("deflate-raw"));
  const letters = btoa(Array.from(data, (byte) => String.fromCharCode(byte)).join(""));
  return `#p=${letters.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`;
}

// The values of a link: { program, scene, exposure } or { example }; null if there are none.
export async function readLink(hash) {
  const [, kind, value] = hash.match(/^#(p|example)=([\w-]+)$/) ?? [];
  if (!kind) return null;
  if (kind === "example") return { example: value };
  const letters = atob(value.replaceAll("-", "+").replaceAll("_", "/"));
  const data = Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
  return JSON.parse(new TextDecoder().decode(await through(data, new DecompressionStream("deflate-raw"))));
}
