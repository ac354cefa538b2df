// The playground page: an editor, a report, pictures of the emulated chip, and the words of a pixel.

import { startEngine } from "./engine.js";
import { coloured, offsetOf } from "./colours.js";
import { greyOfImage, drawGrey, drawMap, bytes, CELLS } from "./pictures.js";
import { readLink, linkOf } from "./link.js";
import { showTrace } from "./trace.js";

const $ = (id) => document.getElementById(id);
const QUIET_MS = 400; // after the last key, before the program is checked
const text = $("text");

let engine, start, saved;
let messages = []; // of the last check
let array = [256, 256];
let map, corner; // the shutter of each pixel, and the pixel at the corner of its picture
let picture = { grey: "", image: null }; // the user's, at the size of the array
let latest = { check: 0, frame: 0, words: 0 };
let exposed = false;

const settings = () => ({
  program: text.value,
  scene: picture.image ? "" : $("scene").value,
  picture: picture.grey,
  exposure_e: Number($("exposure").value),
  effects: $("effects").value,
  seed: Math.trunc(Number($("seed").value)),
  row: Math.trunc(Number($("row").value)),
  col: Math.trunc(Number($("col").value)),
});

function say(line, share = 1) {
  $("status").textContent = line;
  $("progress").hidden = share >= 1;
  if (share < 1) $("progress").value = share;
}

// Ask for something, unless a newer request of the same kind has replaced it meanwhile.
async function ask(kind, task) {
  const number = ++latest[kind];
  const begin = performance.now();
  const waiting = setInterval(() => {
    say(`${task}: ${Math.round((performance.now() - begin) / 1000)} s`);
  }, 1000);
  try {
    const answer = await engine.ask(kind, settings());
    return number === latest[kind] ? answer : null;
  } catch (error) {
    showMessages([{ severity: "error", rendered: error.message, fixes: [], location: null }]);
    return null;
  } finally {
    clearInterval(waiting);
    say(`nscc ${start.version} runs ${engine.place}`);
  }
}

function paint() {
  $("colours").replaceChildren(...coloured(text.value, start.words, messages));
  scrolled();
}

function scrolled() {
  $("colours").scrollTo(text.scrollLeft, text.scrollTop);
}

function showMessages(found) {
  messages = found;
  $("messages").replaceChildren(...found.map((message) => {
    const item = document.createElement("li");
    item.className = message.severity;
    const body = document.createElement("pre");
    body.textContent = message.rendered.trimEnd();
    item.append(body);
    if (message.location) item.append(button(`line ${message.location.row}`, () => goTo(message)));
    for (const fix of message.fixes.filter((fix) => fix.location)) {
      item.append(button(`Fix: ${fix.title}`, () => apply(fix)));
    }
    return item;
  }));
  paint();
}

function button(label, press) {
  const made = document.createElement("button");
  made.textContent = label;
  made.onclick = press;
  return made;
}

function goTo({ location, end_location: end }) {
  text.focus();
  text.setSelectionRange(offsetOf(text.value, location), offsetOf(text.value, end));
}

function apply(fix) {
  const [from, to] = [fix.location, fix.end_location].map((place) => offsetOf(text.value, place));
  text.focus();
  text.setSelectionRange(from, to);
  // Unlike setRangeText, this can be undone by the user.
  if (!document.execCommand("insertText", false, fix.replacement)) {
    text.setRangeText(fix.replacement, from, to, "end");
  }
  check();
}

async function check() {
  const answer = await ask("check", "compiling");
  if (!answer) return false;
  showMessages(answer.messages);
  $("rows").replaceChildren(...(answer.rows ?? []).map(([label, value]) => row("td", [label, value])));
  $("chart").innerHTML = answer.chart ?? ""; // drawn by nscc, which escapes names
  if (answer.rows && !answer.chart) {
    $("chart").textContent = "When the pixels are open depends on their light: expose a picture.";
  }
  array = answer.array ?? array;
  [$("row").max, $("col").max] = [array[0] - 1, array[1] - 1];
  map = answer.map && bytes(answer.map);
  showMap();
  return Boolean(answer.rows);
}

function row(kind, cells) {
  const line = document.createElement("tr");
  line.append(...cells.map((value) => {
    const cell = document.createElement(kind);
    cell.textContent = value;
    return cell;
  }));
  return line;
}

async function expose() {
  if (picture.image) picture.grey = greyOfImage(picture.image, array);
  const answer = await ask("frame", "exposing");
  if (!answer) return;
  exposed = Boolean(answer.pictures);
  $("trace").hidden = true;
  if (!exposed) {
    showMessages(answer.messages);
    return;
  }
  const boxes = answer.pictures.map(figure);
  $("pictures").replaceChildren(...boxes);
  $("lines").textContent = [...answer.lines, `exposed in ${answer.ms} ms`].join("\n");
  $("plan").hidden = !answer.plan;
  $("plan").querySelector("pre").textContent = answer.plan;
  if (!answer.merges) return;
  const number = latest.frame;
  const merged = await engine.ask("merge", settings());
  if (number === latest.frame && merged.pictures) $("pictures").append(...merged.pictures.map(figure));
}

function figure(shown) {
  const box = document.createElement("figure");
  const canvas = document.createElement("canvas");
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", shown.title);
  drawGrey(canvas, shown);
  canvas.onclick = (event) => choose(event);
  const caption = document.createElement("figcaption");
  caption.textContent = shown.title;
  box.append(canvas, caption);
  return box;
}

// A click chooses a pixel: a canvas shows `counts` (rows, columns) of the array from `corner` on.
function choose(event, counts = array, corner = [0, 0]) {
  const box = event.target.getBoundingClientRect();
  const share = [(event.clientY - box.top) / box.height, (event.clientX - box.left) / box.width];
  [$("row").value, $("col").value] = share.map((part, axis) =>
    Math.min(array[axis] - 1, corner[axis] + Math.max(0, Math.floor(part * counts[axis]))));
  follow();
}

function showMap() {
  $("map-box").hidden = !map;
  if (map) corner = drawMap($("map"), array, map, settings());
}

async function follow() {
  showMap();
  const answer = await ask("words", "running the words of the pixel");
  if (!answer) return;
  $("trace").hidden = !answer.steps;
  if (answer.steps) showTrace($, answer, row);
  else showMessages(answer.messages);
}

async function open(program, scene, exposure) {
  text.value = program;
  if (scene) {
    picture = { grey: "", image: null };
    $("scene").value = scene;
    $("exposure").value = exposure;
  }
  if (await check()) await expose();
}

function example(name) {
  const found = start.examples.find((program) => program.name === name);
  if (!found) return false;
  $("example").value = name;
  $("about").textContent = found.about;
  open(found.text, found.scene, found.exposure_e);
  return true;
}

async function usePicture(file) {
  if (!file) return;
  try {
    picture.image = await createImageBitmap(file);
  } catch {
    say("this browser cannot read the picture: convert it to .png or .jpg");
    return;
  }
  expose();
}

async function camera() {
  const video = $("camera");
  let stream;
  try {
    stream = await navigator.mediaDevices.getUserMedia({ video: true });
  } catch (error) {
    say(`no camera: ${error.message}`);
    return;
  }
  video.srcObject = stream;
  await video.play();
  $("shoot").onclick = async () => {
    picture.image = await createImageBitmap(video);
    stream.getTracks().forEach((track) => track.stop());
    video.hidden = $("shoot").hidden = true;
    expose();
  };
  video.hidden = $("shoot").hidden = false;
}

async function save() {
  const answer = await engine.ask("save", { text: text.value, before: saved });
  if (answer.messages) showMessages(answer.messages);
  else {
    saved = text.value;
    say(`saved ${answer.saved}`);
  }
}

function download() {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text.value], { type: "text/plain" }));
  link.download = start.file?.name ?? `${$("example").value || "program"}.nsl`;
  link.click();
  URL.revokeObjectURL(link.href);
}

async function copyLink() {
  const { program, scene, exposure_e: exposure } = settings();
  const hash = await linkOf({ program, scene, exposure });
  history.replaceState(null, "", hash);
  await navigator.clipboard.writeText(engine.shared ? location.href : hash).catch(() => {});
  say(engine.shared ? "the link is in the clipboard and in the address; it holds the program"
    : "the part after # is in the clipboard: it goes after the address of any nscc playground");
}

function listExamples() {
  const groups = Map.groupBy?.(start.examples, ({ task }) => task) ?? new Map([["examples", start.examples]]);
  const first = new Option("your program", "");
  $("example").replaceChildren(first, ...[...groups].map(([task, programs]) => {
    const group = document.createElement("optgroup");
    group.label = task;
    group.append(...programs.map(({ name }) => new Option(name, name)));
    return group;
  }));
}

async function begin() {
  if (location.protocol === "file:") {
    say("browsers run no programs of pages that are files: start `python -m http.server` in this folder", 0);
    return;
  }
  engine = await startEngine(say);
  start = await engine.ask("start", {});
  listExamples();
  $("save").hidden = !start.file;
  say(`nscc ${start.version} runs ${engine.place}`);
  if (await openLink()) return;
  if (start.file) {
    saved = start.file.text;
    open(saved);
  } else example("hdr_2x2");
}

async function openLink() {
  try {
    const link = await readLink(location.hash);
    if (!link) return false;
    if (link.example) return example(link.example);
    open(link.program, link.scene, link.exposure);
    return true;
  } catch {
    // Nothing else is opened: its progress would replace the message.
    say("the part of the address after # is not a program: copy the whole link");
    return true;
  }
}

let quiet;
text.oninput = () => {
  $("example").value = "";
  $("about").textContent = "";
  messages = [];
  paint();
  clearTimeout(quiet);
  quiet = setTimeout(check, QUIET_MS);
};
text.onscroll = scrolled;
$("example").onchange = ({ target }) => target.value && example(target.value);
$("expose").onclick = async () => (await check()) && expose();
for (const id of ["exposure", "effects", "seed"]) $(id).onchange = () => exposed && expose();
$("scene").onchange = ({ target }) => {
  picture = { grey: "", image: null };
  if (target.value === "file") $("file").click();
  else if (target.value === "camera") camera();
  else if (exposed) expose();
};
$("file").onchange = ({ target }) => usePicture(target.files[0]);
$("map").onclick = (event) => choose(event, [CELLS, CELLS], corner);
$("follow").onclick = follow;
$("save").onclick = save;
$("download").onclick = download;
$("link").onclick = copyLink;
window.onhashchange = openLink;

begin().catch((error) => say(`the playground cannot start: ${error.message}`, 0));
