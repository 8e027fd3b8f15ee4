
const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50, 100, 500, 1000];
/** What of the drawing is shown. */
const shown = { rapid: true, feed: true, thread: true, rest: true, grid: true, tool: true, part: true, fixtures: true };

const scene = JSON.parse(byId("scene").textContent);
byId("scene").textContent = "";
const bodies = scene.meshes.map((mesh) => ({ ...mesh, vertices: smooth(numbers(mesh.points), wholes(mesh.triangles)) }));
const curves = scene.curves.map((curve) => {
  const points = numbers(curve.points), line = new Float32Array((points.length / 3) * 5);
  for (let at = 0; 3 * at < points.length; at++) line.set([...points.subarray(3 * at, 3 * at + 3), -1, at ? CURVE : -1], 5 * at);
  return line;
});
const runs = [];

let renderer, camera, run, path, grid, tools, toolSize;
let program = -1, cursor = 0, playing = false, speed = 1, last = 0, marked = 0, asked = false, shownPreset = "iso";
/** What the status says beside the cursor: how long a frame and the start took, ms; what broke. */
const measured = { frame: 0, loaded: 0 };

/** Pieces of the path that are drawn while something moves: as many as the graphics keep up with. At rest all are drawn. */
const LEAST = 4000, REST = 600;
/** What is farther from the middle of the part than this share of its size does not make it small in the view. */
const FAR = 0.75;
let budget = 50000, touched = -Infinity, before = 0, resting = 0;
/** The cameras in their order. */
const cameraNames = () => ["free", ...Object.keys(camera.presets), "section"];
const moving = () => playing || performance.now() - touched < REST;

/** Notes that the view is in use, and asks for the whole path when it is at rest. */
function touch() {
  touched = performance.now();
  clearTimeout(resting);
  resting = setTimeout(ask, REST + 50);
}

/** Which pieces of the path are drawn: while it moves, those about the tool. */
function nearPieces(motion) {
  const all = path.length / 5;
  if (!moving() || budget >= all) return {};
  const at = motion < 0 ? 0 : run.pieceOf[motion];
  return { first: Math.round(Math.max(0, Math.min(at - 0.7 * budget, all - budget))), most: budget };
}

function makeRenderer() {
  const canvas = byId("view");
  if (!/[#&]flat\b/.test(location.hash)) {
    try {
      renderer = new Gl(canvas);
      canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
      canvas.addEventListener("webglcontextrestored", () => {
        renderer.prepare();
        ask();
      });
      return;
    } catch {
      // The plain drawing takes its place, on a canvas that has no other context.
      canvas.replaceWith(canvas.cloneNode());
    }
  }
  renderer = new Flat(byId("view"));
}

const readout = new Readout();
const list = new BlockList((line) => goToLine(line));

/** The minimum and maximum coordinates of what is shown: of the part or, without one, of the path. */
function extent() {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  const add = (x, y, z) => [x, y, z].forEach((value, axis) => {
    low[axis] = Math.min(low[axis], value);
    high[axis] = Math.max(high[axis], value);
  });
  const own = !run.data.diameter || !runs.some((one) => !one.data.diameter);
  if (own || !run.metal) for (const body of bodies) {
    for (let at = 0; at < body.vertices.length; at += 6) add(...body.vertices.subarray(at, at + 3));
  }
  for (const outline of run.metal?.stock ?? []) {
    for (let at = 0; at < outline.length; at += 2) for (const r of [outline[at + 1], -outline[at + 1]]) add(r, r, outline[at]);
  }
  const cutting = low[0] === Infinity;
  const span = cutting ? Infinity : Math.hypot(...high.map((value, axis) => value - low[axis]));
  const middle = low.map((value, axis) => (value + high[axis]) / 2);
  for (const feeds of [true, false]) {
    for (let at = 0; at < path.length; at += 5) {
      if (feeds && (path[at + 4] <= RAPID)) continue;
      const off = Math.max(...[0, 1, 2].map((axis) => Math.abs(path[at + axis] - middle[axis])));
      if (!cutting && off >= FAR * span) continue;
      add(path[at], path[at + 1], path[at + 2]);
      if (at > 0 && path[at + 4] > RAPID) add(path[at - 5], path[at - 4], path[at - 3]);
    }
    if (low[0] !== Infinity) break;
  }
  if (low[0] === Infinity) add(0, 0, 0), add(100, 100, 100);
  if (run.data.diameter) add(0, 0, low[2]);
  return [low, high];
}

function chooseProgram(index) {
  if (index === program || !scene.programs[index]) return;
  program = index;
  runs[index] ??= new Run(scene.programs[index]);
  run = runs[index];
  byId("program").value = String(index);
  renderer.forget();
  path = run.path();
  const turning = run.data.diameter, [low, high] = extent();
  const size = Math.hypot(...high.map((value, axis) => value - low[axis]));
  camera = new Camera(turning, run.data.turning?.up === false);
  camera.untouched = true;
  camera.sectionAt = turning || scene.meshes.length ? [0, 0, 0].map((zero, axis) => (low[axis] < 0 && high[axis] > 0 ? zero : (low[axis] + high[axis]) / 2)) : undefined;
  tools = new Map();
  toolSize = size;
  pause();
  cursor = 0;
  marked = 0;
  camera.bounds(low, high);
  preset(turning ? "plan" : "iso");
  grid = gridLines(low, high, turning);
  chooseSpeed(SPEEDS.find((one) => one >= 1 && run.total / one <= 120) ?? SPEEDS.at(-1));
  readout.show(run);
  list.show(run);
  labelAll();
  ask();
}

/** The tool of a number: its bodies, made once. */
function toolOf(number) {
  const { tools: given } = run.data;
  const tool = given.find((one) => one.number === number) ?? given[0];
  if (!tools.has(tool)) tools.set(tool, toolBodies(tool, run.data.diameter, toolSize));
  return tools.get(tool);
}

/** Points of a torch where it stands, which cameras take in; none of one far from its part, nor of another tool: the shank
 * of a milling tool would make the part small, and a turning tool stands beside its part. */
function standingTorch() {
  const [motion, part] = run.at(cursor), torch = run.data.tools[0]?.shape.torch;
  if (motion < 0 || !torch || !shown.tool) return [];
  const tip = run.point(motion, part);
  if (Math.max(...tip.map((value, axis) => Math.abs(value - camera.centre[axis]))) >= FAR * toolSize) return [];
  const model = standing(tip, run.direction(motion, part));
  const points = toolOf(0).flatMap(({ vertices }) => Array.from({ length: vertices.length / 6 }, (_, at) => vertices.subarray(6 * at, 6 * at + 3)));
  return points.map(([x, y, z]) => tip.map((value, axis) => value + model[axis] * x + model[4 + axis] * y + model[8 + axis] * z));
}

/** Fits the part, with its torch, into the view. */
function fit() {
  camera.beside = standingTorch();
  camera.fit();
  ask();
}

function ask() {
  if (asked) return;
  asked = true;
  requestAnimationFrame(frame);
}

function frame(now) {
  asked = false;
  if (moving()) {
    const took = now - before;
    if (took > 90 && took < 5000) budget = Math.max(LEAST, budget / 2);
    else if (took < 40 && budget < path.length) budget *= 2;
  }
  before = now;
  if (playing) {
    const time = run.timeAt(cursor) + Math.max(0, Math.min(now - last, 250)) * 0.001 * speed;
    // A motion that takes no time must not hold the rest up, nor may a program of which none does.
    cursor = time >= run.total ? run.count : Math.max(cursor, run.cursorAt(time));
    last = now;
    if (cursor >= run.count) pause();
    else ask();
  }
  const began = performance.now();
  draw();
  measured.frame = performance.now() - began;
  tell();
}

const ghost = (paint) => (paint === "ghost" ? 0.28 : paint === "fixture" ? 0.6 : 1);

function draw() {
  const view = byId("view"), ratio = Math.min(devicePixelRatio || 1, 2);
  const [width, height] = [view.clientWidth, view.clientHeight].map((size) => Math.max(1, Math.round(size * ratio)));
  const [motion, part] = run.at(cursor);
  renderer.begin(camera, width, height, ratio);
  if (shown.grid) renderer.lines(grid.lines, { width: 1 });
  const tip = motion >= 0 ? run.point(motion, part) : null;
  const others = run.data.diameter && run.metal ? [] : bodies;
  const parts = shown.part ? others : [];
  parts.filter((body) => ghost(body.paint) === 1).forEach((body) => renderer.mesh(body.vertices, body.paint));
  if (run.metal && shown.part) renderer.turn(run.metal.pieces(motion, part, tip, motion >= 0 ? run.heading(motion, part) : null), "metal");
  if (shown.part) curves.forEach((curve) => renderer.lines(curve, { width: 2.4, through: 0.3 }));
  const hidden = [];
  if (!shown.rapid) hidden.push(RAPID);
  if (!shown.feed) hidden.push(FEED, CLOCKWISE, COUNTER);
  if (!shown.thread) hidden.push(THREAD);
  const near = nearPieces(motion);
  renderer.lines(path, { hidden, now: cursor, rest: shown.rest ? 0.3 : 0, through: budget < path.length / 5 ? 0 : 0.35, ...near });
  if (tip && shown.tool) drawTool(motion, part, tip);
  parts.filter((body) => ghost(body.paint) < 1).forEach((body) => renderer.mesh(body.vertices, body.paint, ghost(body.paint)));
  const piece = shown.part && run.metal ? run.metal.piece(motion, part) : null;
  if (piece) renderer.turn(piece, "ghost", ghost("ghost"));
  if (run.metal && shown.fixtures) {
    for (const fixture of run.metal.fixtures) {
      fixture.pieces ??= outlinePieces([fixture.outline]);
      renderer.turn(fixture.pieces, "fixture", ghost("fixture"));
    }
  }
  renderer.end();
  drawOver(width, height, ratio);
  const time = run.timeAt(cursor);
  byId("clock").textContent = `${clock(time)} / ${clock(run.total)}`;
  const scrub = byId("scrub");
  scrub.max = String(run.total > 0 ? run.total : run.count);
  scrub.value = String(run.total > 0 ? time : cursor);
  scrub.setAttribute("aria-valuetext", clock(time));
  measured.said = readout.draw(motion, part);
  list.mark(marked || (motion >= 0 && cursor > 0 ? run.line[motion] : 0));
}

function drawTool(motion, part, tip) {
  const direction = run.direction(motion, part);
  const model = run.data.diameter
    ? new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, ...tip, 1])
    : standing(tip, direction);
  if (!run.data.diameter) {
    const far = tip.map((value, axis) => value + direction[axis] * toolSize);
    const line = new Float32Array([...tip, -1, -1, ...far, -1, AXIS_TOOL]);
    renderer.lines(line, { width: 1.2, through: 0.5 });
    renderer.drop(line);
  }
  for (const body of toolOf(run.states[run.state[motion]].tool)) renderer.mesh(body.vertices, body.paint, 1, model, true);
}

/** Letters of the axes and the grid's step, over the drawing. */
function drawOver(width, height, ratio) {
  const canvas = byId("over"), context = canvas.getContext("2d");
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  context.clearRect(0, 0, width, height);
  // The grid's step stands below the letter of an axis that points down.
  const size = 30 * ratio, at = [width - 52 * ratio, height - (shown.grid ? 64 : 46) * ratio], { right, up } = camera.axes();
  context.font = `600 ${12 * ratio}px system-ui, sans-serif`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.lineWidth = 2 * ratio;
  ["x", "y", "z"].forEach((name, axis) => {
    const [x, y] = [right[axis] * size, -up[axis] * size];
    if (Math.hypot(x, y) < 0.15 * size) return;
    context.strokeStyle = context.fillStyle = colour(name);
    context.beginPath();
    context.moveTo(...at);
    context.lineTo(at[0] + x, at[1] + y);
    context.stroke();
    context.fillText(name.toUpperCase(), at[0] + x * 1.35, at[1] + y * 1.35);
  });
  if (!shown.grid) return;
  context.fillStyle = colour("text");
  context.globalAlpha = 0.7;
  context.font = `${11 * ratio}px system-ui, sans-serif`;
  context.textAlign = "right";
  context.fillText(`${say("grid")} ${grid.step} mm`, width - 8 * ratio, height - 8 * ratio);
  context.globalAlpha = 1;
}

/** Gives the state of the page, for scripts. */
function tell() {
  const [motion] = run.at(cursor);
  byId("status").textContent = JSON.stringify({
    program, cursor, motion, motions: run.count, lines: run.blocks.length, line: list.line, time: run.timeAt(cursor), total: run.total,
    playing, speed, language, renderer: renderer.name, triangles: renderer.triangles, preset: shownPreset, section: camera.section,
    edits: run.metal?.count ?? 0, ...measured,
  });
}

function preset(name) {
  camera.beside = standingTorch();
  if (name === "section") camera.section = !camera.section;
  if (name === "section" && camera.section) camera.preset("section");
  else if (name !== "section") camera.preset(name);
  camera.untouched = true;
  shownPreset = name;
  for (const button of byId("cameras").children) {
    const on = button.dataset.name === "section" ? camera.section : button.dataset.name === name;
    button.setAttribute("aria-pressed", String(on));
  }
  ask();
}

function pause() {
  playing = false;
  touch();
  byId("play").setAttribute("aria-pressed", "false");
}

function play() {
  if (run.count === 0) return;
  if (cursor >= run.count) cursor = 0;
  playing = true;
  marked = 0;
  last = performance.now();
  byId("play").setAttribute("aria-pressed", "true");
  ask();
}

function goTo(to, line = 0) {
  cursor = Math.max(0, Math.min(run.count, to));
  marked = line;
  last = performance.now();
  touch();
  ask();
}

function goToLine(line) {
  pause();
  goTo(run.cursorOfLine(line), line);
}

function step(by) {
  pause();
  goTo(by > 0 ? Math.floor(cursor + 1e-9) + by : Math.ceil(cursor - 1e-9) + by);
}

function chooseSpeed(wanted) {
  speed = wanted;
  byId("speed").value = String(wanted);
}

function faster(by) {
  chooseSpeed(SPEEDS[Math.max(0, Math.min(SPEEDS.length - 1, SPEEDS.indexOf(speed) + by))]);
  ask();
}

/** Puts all words into the language in force. */
function labelAll() {
  speak();
  byId("title").textContent = document.title = scene.title;
  byId("answer").textContent = "";
  const choose = byId("program");
  choose.replaceChildren();
  scene.programs.forEach((one, index) => {
    const option = make("option", choose, pick(one.title));
    option.value = String(index);
  });
  choose.value = String(program);
  choose.hidden = scene.programs.length < 2;
  const cameras = byId("cameras");
  cameras.replaceChildren();
  cameraNames().forEach((name) => {
    const button = make("button", cameras, say(name === "plan" && run.data.diameter ? "planZX" : name));
    button.type = "button";
    button.dataset.name = name;
    button.setAttribute("aria-pressed", String(name === "section" ? camera.section : name === shownPreset));
    button.addEventListener("click", () => preset(name));
  });
  const switches = byId("switches");
  switches.replaceChildren();
  const used = { thread: run.kind.includes(THREAD), part: scene.meshes.length > 0 || run.metal, fixtures: run.metal?.fixtures.length };
  for (const name of Object.keys(shown)) {
    if (name in used && !used[name]) continue;
    const label = make("label", switches), box = make("input", label);
    box.type = "checkbox";
    box.id = `layer-${name}`;
    box.checked = shown[name];
    box.addEventListener("change", () => {
      shown[name] = box.checked;
      ask();
    });
    if (COLOURS[name]) make("i", label).style.background = colour(name);
    make("span", label, say(name));
  }
  const notes = byId("notes"), { assumed } = run.data;
  notes.replaceChildren();
  const said = run.data.notes.map(pick);
  if (run.still) said.push(say("empty"));
  if (assumed[0]) said.push(say("assumedRapid"));
  if (assumed[1]) said.push(say("assumedFeed"));
  if (renderer.name === "2d") said.push(say("flat"));
  said.forEach((text) => make("li", notes, text));
  showRemarks(run, (remark) => {
    if (remark.motion === null) goToLine(remark.line);
    else pause(), goTo(remark.motion + 1, remark.line ?? 0);
    chooseTab("blocks");
  });
  showHelp();
}

function switchLanguage(to) {
  language = to;
  labelAll();
  ask();
}

function search() {
  const line = run.search(byId("wanted").value, list.line);
  byId("answer").textContent = line || !byId("wanted").value.trim() ? "" : say("nowhere");
  if (line) goToLine(line);
}

function key(event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const field = event.target.closest?.("input:not([type=range]):not([type=checkbox]), select");
  if (field) {
    if (event.key === "Escape") byId("view").focus();
    return;
  }
  const pressed = event.target.closest?.("button, summary, input[type=checkbox]") && (event.key === " " || event.key === "Enter");
  if (pressed) return;
  const names = cameraNames(), far = event.shiftKey ? 100 : 1;
  const block = (by) => {
    const lines = run.blocks.length;
    for (let line = list.line + by; line >= 1 && line <= lines; line += by) {
      if (run.ofLine[line] >= 0) return goToLine(line);
    }
  };
  // Feed motions that follow a rapid one are a pass.
  const begins = (at) => !stands(run.kind[at]) && run.kind[at] !== RAPID && (at === 0 || [RAPID, NONE].includes(run.modal[at - 1]));
  const pass = (by) => {
    let at = by > 0 ? Math.floor(cursor + 1e-9) + 1 : Math.ceil(cursor - 1e-9) - 1;
    while (at > 0 && at < run.count && !begins(at)) at += by;
    pause();
    goTo(at);
  };
  const keys = {
    " ": () => (playing ? pause() : play(), ask()),
    ArrowRight: () => step(far),
    ArrowLeft: () => step(-far),
    ArrowDown: () => block(1),
    ArrowUp: () => block(-1),
    PageDown: () => pass(1),
    PageUp: () => pass(-1),
    Home: () => (pause(), goTo(0)),
    End: () => (pause(), goTo(run.count)),
    "+": () => faster(1),
    "-": () => faster(-1),
    f: fit,
    s: () => preset("section"),
    "/": () => (chooseTab("blocks"), byId("wanted").focus()),
    l: () => switchLanguage(language === "es" ? "en" : "es"),
    "?": () => chooseTab("help"),
  };
  const name = names[Number(event.key) - 1];
  const action = name ? () => preset(name) : keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
  if (!action) return;
  event.preventDefault();
  action();
}

/** What is after the # of the address: `program=2&goto=N60&step=12&time=3.5&view=plan&lang=es&play`. */
function follow() {
  const wanted = new URLSearchParams(location.hash.slice(1));
  if (["es", "en"].includes(wanted.get("lang"))) switchLanguage(wanted.get("lang"));
  if (wanted.has("program")) chooseProgram(Number(wanted.get("program")) - 1);
  const view = wanted.get("view"), tab = wanted.get("tab"), number = (name) => Number(wanted.get(name)) || 0;
  if (cameraNames().includes(view) && !(view === "section" && camera.section)) preset(view);
  if (TABS.includes(tab)) chooseTab(tab);
  if (wanted.has("goto")) {
    const line = run.search(wanted.get("goto"), 0);
    if (line) goToLine(line);
  }
  if (wanted.has("step")) goTo(number("step"));
  if (wanted.has("time")) goTo(run.cursorAt(number("time")));
  if (camera.untouched) fit();
  if (wanted.has("play")) play();
}

function begin() {
  makeRenderer();
  for (const one of SPEEDS) {
    const option = make("option", byId("speed"), `${one}×`);
    option.value = String(one);
  }
  chooseTab("blocks");
  chooseProgram(0);
  byId("program").addEventListener("change", (event) => chooseProgram(Number(event.target.value)));
  byId("language").addEventListener("click", () => switchLanguage(language === "es" ? "en" : "es"));
  byId("first").addEventListener("click", () => (pause(), goTo(0)));
  byId("last").addEventListener("click", () => (pause(), goTo(run.count)));
  byId("back").addEventListener("click", () => step(-1));
  byId("forward").addEventListener("click", () => step(1));
  byId("play").addEventListener("click", () => (playing ? pause() : play(), ask()));
  byId("speed").addEventListener("change", (event) => chooseSpeed(Number(event.target.value)));
  byId("scrub").addEventListener("input", (event) => {
    pause();
    goTo(run.total > 0 ? run.cursorAt(Number(event.target.value)) : Number(event.target.value));
  });
  byId("search").addEventListener("submit", (event) => (event.preventDefault(), search()));
  for (const tab of TABS) byId(`tab-${tab}`).addEventListener("click", () => chooseTab(tab));
  byId("tabs").addEventListener("keydown", (event) => {
    const now = TABS.findIndex((tab) => !byId(tab).hidden);
    const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!by) return;
    event.stopPropagation();
    const next = TABS[(now + by + TABS.length) % TABS.length];
    chooseTab(next);
    byId(`tab-${next}`).focus();
  });
  addEventListener("keydown", key);
  addEventListener("hashchange", follow);
  dark.addEventListener("change", () => (labelAll(), ask()));
  new ResizeObserver(ask).observe(byId("stage"));
  listenToPointers(byId("view"), () => camera, () => (touch(), ask()), () => (touch(), fit()));
  follow();
  measured.loaded = performance.now();
  ask();
}

begin();
