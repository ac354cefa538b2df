// The playground page: an editor, a report, pictures of the emulated chip, and the words of a pixel.

import { startEngine } from "./engine.js";
import { Editor } from "./editor.js";
import { lightOfImage, drawGrey, drawMap, bytes, CELLS } from "./pictures.js";
import { readLink, linkOf } from "./link.js";
import { showTrace } from "./trace.js";

const $ = (id) => document.getElementById(id);
const QUIET_MS = 400; // after the last key, before the program is checked

let engine, start, saved, editor;
let array = [256, 256];
let map, corner; // the shutter of each pixel, and the pixel at the corner of its picture
let picture = { light: "", image: null }; // the user's, at the size of the array
let latest = { check: 0, frame: 0, words: 0 };
let exposed = false;

const settings = () => ({
  program: editor.text,
  scene: picture.image ? "" : $("scene").value,
  picture: picture.light,
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

function showMessages(messages) {
  $("messages").replaceChildren(...messages.map((message) => {
    const item = document.createElement("li");
    item.className = message.severity;
    const body = document.createElement("pre");
    body.textContent = message.rendered.trimEnd();
    item.append(body);
    if (message.location) item.append(button(`line ${message.location.row}`, () => editor.select(message)));
    for (const fix of message.fixes.filter((fix) => fix.location)) {
      item.append(button(`Fix: ${fix.title}`, () => editor.apply(fix)));
    }
    return item;
  }));
  editor.show(messages);
}

function button(label, press) {
  const made = document.createElement("button");
  made.textContent = label;
  made.onclick = press;
  return made;
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
  if (picture.image) picture.light = lightOfImage(picture.image, array);
  const begin = performance.now();
  const answer = await ask("frame", "exposing");
  if (!answer) return;
  exposed = Boolean(answer.pictures);
  $("trace").hidden = true;
  if (!exposed) {
    showMessages(answer.messages);
    return;
  }
  $("pictures").replaceChildren(...answer.pictures.map(figure));
  $("lines").textContent = [...answer.lines, `exposed in ${Math.round(performance.now() - begin)} ms`].join("\n");
  $("plan").hidden = !answer.plan;
  $("plan").querySelector("pre").textContent = answer.plan;
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
  editor.open(program);
  if (scene) {
    picture = { light: "", image: null };
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
  open(found.text, found.scene, found.exposure);
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
  const answer = await engine.ask("save", { text: editor.text, before: saved });
  if (answer.messages) showMessages(answer.messages);
  else {
    saved = editor.text;
    say(`saved ${answer.saved}`);
  }
}

function download() {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([editor.text], { type: "text/plain" }));
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
  $("docs").hidden = !engine.docs;
  $("docs").href = engine.docs ?? "";
  start = await engine.ask("start", {});
  editor = new Editor($("text"), start.words, changed);
  $("text").editor = editor; // for scripts
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
function changed() {
  $("example").value = "";
  $("about").textContent = "";
  clearTimeout(quiet);
  quiet = setTimeout(check, QUIET_MS);
}

$("example").onchange = ({ target }) => target.value && example(target.value);
$("expose").onclick = async () => (await check()) && expose();
for (const id of ["exposure", "effects", "seed"]) $(id).onchange = () => exposed && expose();
$("scene").onchange = ({ target }) => {
  picture = { light: "", image: null };
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
