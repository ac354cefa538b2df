// Pictures: from files and cameras to the array's grey levels, and from answers to canvases.

const LUMINANCE = [0.2126, 0.7152, 0.0722];
const HUES = 137.5; // degrees between the colours of shutters in the map
export const CELLS = 16; // pixels of the array along a side of the map
const CELL = 16; // of the screen

export const bytes = (base64) => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));

// The middle of an image, scaled to the array, as light in base64 (float32): that of the brightest percent is 1.
export function lightOfImage(image, [rows, cols]) {
  const canvas = new OffscreenCanvas(cols, rows);
  const context = canvas.getContext("2d");
  const scale = Math.max(cols / image.width, rows / image.height);
  const [width, height] = [image.width * scale, image.height * scale];
  context.imageSmoothingQuality = "high";
  context.drawImage(image, (cols - width) / 2, (rows - height) / 2, width, height);
  const { data } = context.getImageData(0, 0, cols, rows);
  const linear = (level) => (level <= 0.04045 ? level / 12.92 : ((level + 0.055) / 1.055) ** 2.4);
  const table = Float64Array.from({ length: 256 }, (_, level) => linear(level / 255));
  const light = new Float32Array(rows * cols).map((_, k) =>
    LUMINANCE.reduce((sum, weight, channel) => sum + weight * table[data[4 * k + channel]], 0));
  const white = light.toSorted()[Math.floor((light.length - 1) * 0.99)] || 1;
  const letters = Array.from(new Uint8Array(light.map((value) => value / white).buffer), (byte) => String.fromCharCode(byte));
  return btoa(letters.join(""));
}

export function drawGrey(canvas, { shape: [rows, cols], grey }) {
  [canvas.height, canvas.width] = [rows, cols];
  const context = canvas.getContext("2d");
  const image = context.createImageData(cols, rows);
  bytes(grey).forEach((level, k) => image.data.set([level, level, level, 255], 4 * k));
  context.putImageData(image, 0, 0);
}

// The shutters around a pixel, one colour each. `data`: 16 bits a pixel, the lower byte first.
// Returns the row and the column of the corner.
export function drawMap(canvas, [rows, cols], data, { row, col }) {
  const side = CELLS * CELL;
  [canvas.height, canvas.width] = [side, side];
  const context = canvas.getContext("2d");
  const corner = [[row, rows], [col, cols]].map(([at, count]) =>
    Math.max(0, Math.min(at - CELLS / 2, count - CELLS)));
  for (let y = 0; y < Math.min(CELLS, rows); y++) {
    for (let x = 0; x < Math.min(CELLS, cols); x++) {
      const k = (corner[0] + y) * cols + corner[1] + x;
      const shutter = data[2 * k] + 256 * data[2 * k + 1];
      context.fillStyle = `hsl(${shutter * HUES} 55% 55%)`;
      context.fillRect(x * CELL, y * CELL, CELL - 1, CELL - 1);
    }
  }
  context.lineWidth = 3;
  context.strokeRect((col - corner[1]) * CELL, (row - corner[0]) * CELL, CELL, CELL);
  return corner;
}
