/* A playground in the browser: controls, a canvas, handles on it, and messages to the one who makes the pictures. That
is the kernel (kflearn/ui/live.py), or, on the web page, pictures recorded beforehand (recorded.js).

model.get("spec") says what there is; messages are described where they are sent and taken. Points are in device pixels
of the canvas, counted from its upper left corner. */

// ---- drawing what a Recorder has kept (kflearn/ui/recorder.py)

function trace(pen, points, [first, count, codes]) {
  let i = 2 * first;
  if (!codes && count) pen.moveTo(points[i], points[i + 1]);
  for (let k = codes ? 0 : 1; k < count; k++) {
    i = 2 * (first + k);
    const [x, y] = [points[i], points[i + 1]];
    if (!codes || codes[k] === "2") pen.lineTo(x, y);
    else if (codes[k] === "1") pen.moveTo(x, y);
    else if (codes[k] === "9") pen.closePath();
    else if (codes[k] === "3") (k += 1), pen.quadraticCurveTo(x, y, points[i + 2], points[i + 3]);
    else (k += 2), pen.bezierCurveTo(x, y, ...points.subarray(i + 2, i + 6));
  }
}

function shape(points, place) {
  const path = new Path2D();
  trace(path, points, place);
  return path;
}

function use(pen, [width, line, dashes, fill, cap, join]) {
  if (fill) pen.fillStyle = fill;
  if (!line) return;
  pen.strokeStyle = line;
  pen.lineWidth = width;
  pen.lineCap = cap === "projecting" ? "square" : cap;
  pen.lineJoin = join;
  pen.setLineDash(dashes ? dashes.slice(1) : []);
  pen.lineDashOffset = dashes ? dashes[0] : 0;
}

function ink(pen, path, style) {
  if (style[3]) pen.fill(path);
  if (style[1]) pen.stroke(path);
}

function limit(pen, points, clip) {
  const path = clip.length === 3 ? shape(points, clip) : new Path2D();
  if (clip.length === 4) path.rect(...clip);
  pen.clip(path);
}

export function paint(pen, { ops, styles }, points, images) {
  for (const [kind, ...op] of ops) {
    pen.save();
    const clip = op.at(-1);
    if (clip) limit(pen, points, clip);
    if (kind === "i") {
      pen.globalAlpha = op[3];
      pen.drawImage(images[op[0]], op[1], op[2]);
    } else {
      const style = styles[op.at(-2)];
      use(pen, style);
      if (kind === "p") ink(pen, shape(points, op[0]), style);
      else stamp(pen, points, op[0], shape(points, op[1]), style);
    }
    pen.restore();
  }
}

function stamp(pen, points, [first, count], marker, style) {
  for (let i = 2 * first; i < 2 * (first + count); i += 2) {
    pen.translate(points[i], points[i + 1]);
    ink(pen, marker, style);
    pen.translate(-points[i], -points[i + 1]);
  }
}

// ---- controls: each has an element, set(value) to show a value, and names the value that the hand gives it

function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (value !== false && value !== undefined) made.setAttribute(name, value === true ? "" : value);
  }
  made.append(...children);
  return made;
}

function words(html) {
  const made = element("span", { class: "kf-label" });
  made.innerHTML = html; // made by kflearn/ui/labels.py, which escapes the words
  return made;
}

function number(value) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  return size >= 1e6 || size < 1e-4 ? Number(value.toPrecision(6)).toExponential().replace("e+", "e") : String(value);
}

function nearest({ places, log }, value) {
  if (places.includes(value)) return places.indexOf(value);
  const scale = log ? Math.log : Number;
  const gaps = places.map((place) => Math.abs(scale(place) - scale(value)));
  return gaps.indexOf(Math.min(...gaps));
}

function slider(control, moved) {
  const { low, high, log, whole, unit, places } = control; // places: the only values that there are, on the web page
  const step = places ? 1 : control.step;
  const place = (value) => (places ? nearest(control, value) : log ? Math.log10(value) : value);
  const value = (place) => {
    if (places) return places[place];
    const found = log ? Number((10 ** place).toPrecision(3)) : whole ? Math.round(place) : Number(place.toFixed(10));
    return Math.min(Math.max(found, low), high);
  };
  const name = { "aria-label": control.plain };
  const bar = element("input", { type: "range", min: place(low), max: place(high), step, ...name });
  const box = element("input", { type: "text", inputmode: "decimal", class: "kf-box", ...name, title: control.range });
  const show = (now) => {
    box.value = number(now);
    box.style.width = `${Math.max(control.digits, box.value.length) + 2}ch`;
    bar.setAttribute("aria-valuetext", `${number(now)} ${unit}`.trim());
  };
  let shown;
  bar.addEventListener("input", () => {
    shown = value(Number(bar.value));
    show(shown);
    moved(shown);
  });
  box.addEventListener("change", () => {
    const typed = Number(box.value.trim().replace(",", "."));
    if (!box.value.trim() || !Number.isFinite(typed)) return show(shown);
    const taken = Math.min(Math.max(whole ? Math.trunc(typed) : typed, low), high);
    set(taken);
    moved(taken);
  });
  function set(now) {
    shown = now;
    if (Math.abs(Number(bar.value) - place(now)) > 0.51 * step) bar.value = place(now);
    show(now);
  }
  const shell = element("label", { class: "kf-slider" }, words(control.label), box, ` ${unit} `);
  return { element: element("div", { class: "kf-control" }, shell, bar), set };
}

function choice(control, moved) {
  const group = `kf-${Math.random().toString(36).slice(2)}`;
  const buttons = control.options.map((option) => {
    const input = element("input", { type: "radio", name: group, onchange: () => input.checked && moved(option) });
    return [option, input, element("label", { class: "kf-option" }, input, element("span", {}, String(option)))];
  });
  const set = (now) => buttons.forEach(([option, input]) => (input.checked = option === now));
  const all = buttons.map(([, , label]) => label);
  const about = { class: "kf-choice", role: "radiogroup", "aria-label": control.plain };
  return { element: element("div", { class: "kf-control" }, words(control.label), element("div", about, ...all)), set };
}

function toggle(control, moved) {
  const input = element("input", { type: "checkbox", onchange: () => moved(input.checked) });
  const label = element("label", { class: "kf-toggle" }, input, words(control.label));
  return { element: element("div", { class: "kf-control" }, label), set: (now) => (input.checked = now) };
}

// ---- handles: what one can take hold of in the picture

function handle(i, move, nudge) {
  const made = element("button", { class: "kf-handle", type: "button", hidden: true });
  let from = null;
  const scale = () => made.parentElement.querySelector("canvas").width / made.parentElement.clientWidth;
  made.addEventListener("pointerdown", (event) => {
    made.setPointerCapture(event.pointerId);
    from = [made.at[0] - event.clientX * scale(), made.at[1] - event.clientY * scale()];
    made.focus();
    event.preventDefault();
  });
  made.addEventListener("pointermove", (event) => {
    if (from) move(i, [from[0] + event.clientX * scale(), from[1] + event.clientY * scale()]);
  });
  for (const end of ["pointerup", "pointercancel"]) made.addEventListener(end, () => (from = null));
  const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  made.addEventListener("keydown", (event) => {
    if (!steps[event.key]) return;
    event.preventDefault();
    nudge(i, steps[event.key].map((part) => part * (event.shiftKey ? 10 : 1)));
  });
  return made;
}

function together(nudge, another) {
  if (!another || another[0] !== nudge[0]) return another || nudge;
  return [nudge[0], nudge[1] + another[1], nudge[2] + another[2]];
}

function put(made, { hidden, at, area, along, line, words }, picture) {
  made.hidden = Boolean(hidden);
  if (hidden) return;
  made.at = at;
  made.className = `kf-handle kf-along-${along}${line ? " kf-line" : ""}`;
  const [x, y, width, height] = area;
  const [across, down] = [(part) => `${(100 * part) / picture.width}%`, (part) => `${(100 * part) / picture.height}%`];
  Object.assign(made.style, { left: across(x + width / 2), top: down(y + height / 2) }); // its middle
  Object.assign(made.style, { width: across(width), height: down(height) });
  if (made.getAttribute("aria-label") !== words) made.setAttribute("aria-label", words);
}

// ---- the whole

const BUSY = "The kernel is busy with a cell. The picture follows when it is free.";
const LOST = "The kernel does not answer. If no cell is running: Kernel → Restart Kernel, then run the cells again.";
const MANY = 2; // moves under way at once: while one picture is drawn, the next is made
const PATIENCE = [1.5, 20]; // seconds without an answer, until these sentences are shown

export function render({ model, el }) {
  const spec = model.get("spec");
  const view = Math.random().toString(36).slice(2);
  const [wide, high] = spec.size;
  const [canvas, below] = [element("canvas", { role: "img" }), document.createElement("canvas")];
  const sentence = element("p", { class: "kf-sentence", "aria-hidden": "true" });
  const spoken = element("p", { class: "kf-spoken", role: "status", "aria-live": "polite" });
  const frame = element("div", { class: "kf-picture" }, canvas);
  const state = { waiting: 0, sent: 0, epoch: 0, next: null, stage: null, ratio: 0, asked: {} };
  let order = Promise.resolve();

  // -- moves: { kind: "move", view, n, epoch, values, drag, nudge, reset }

  function ask(change, names) {
    for (const name of names) state.asked[name] = state.sent + 1; // the move that will carry it
    const { nudge, values, ...rest } = state.next && !change.reset ? state.next : {};
    state.next = { ...rest, ...change, values: { ...values, ...change.values } };
    if (nudge && !change.drag) state.next.nudge = together(nudge, change.nudge);
    send();
  }
  function send() {
    if (!state.next || state.waiting >= MANY) return;
    state.waiting += 1;
    state.sent += 1;
    tell({ kind: "move", view, n: state.sent, epoch: state.epoch, ...state.next });
    state.next = null;
    if (state.waiting === 1) watch();
  }
  function tell(message) {
    try {
      model.send(message);
    } catch (error) {
      console.warn(error);
      say(LOST);
    }
  }
  function watch() {
    clearTimeout(state.busy);
    clearTimeout(state.lost);
    if (!state.waiting && state.stage) return;
    const [busy, lost] = spec.patience || PATIENCE;
    state.busy = setTimeout(() => say(spec.busy ?? BUSY), 1000 * busy);
    state.lost = setTimeout(() => say(spec.lost ?? LOST), 1000 * lost);
  }

  const controls = Object.fromEntries(
    spec.controls.map((control) => {
      const make = { slider, choice, toggle }[control.kind];
      return [control.name, make(control, (value) => ask({ values: { [control.name]: value } }, [control.name]))];
    }),
  );
  const all = Object.keys(controls);
  const reset = element("button", { class: "kf-reset", type: "button", onclick: () => ask({ reset: true, values: {} }, all) });
  reset.append("Reset");
  const handles = spec.handles.map((names, i) =>
    handle(i, (i, at) => ask({ drag: [i, ...at] }, names), (i, by) => ask({ nudge: [i, ...by] }, names)),
  );
  frame.append(...handles);
  const row = element("div", { class: "kf-controls" }, ...all.map((name) => controls[name].element));
  const under = element("div", { class: "kf-under" }, sentence, reset);
  const style = `max-width: ${wide}px`;
  const whole = element("div", { class: "kf-playground", style }, row, under, spoken, frame);
  // Else Notebook 7 takes the arrow keys for itself, and JupyterLab those that come up to it.
  for (const made of whole.querySelectorAll("input, button")) made.setAttribute("data-lm-suppress-shortcuts", "true");
  for (const part of [row, under]) {
    for (const kind of ["keydown", "keyup"]) part.addEventListener(kind, (event) => event.stopPropagation());
  }
  frame.addEventListener("keydown", (event) => event.stopPropagation());
  frame.style.aspectRatio = `${wide} / ${high}`;
  el.replaceChildren(whole);

  function say(text) {
    if (sentence.textContent === text) return;
    sentence.textContent = text;
    requestAnimationFrame(grow); // not now: to ask for a height would make the browser lay the page out twice
    clearTimeout(state.speak);
    state.speak = setTimeout(() => (spoken.textContent = text), 700);
  }

  function grow() {
    const before = parseFloat(sentence.style.minHeight) || 0;
    if (sentence.scrollHeight > before) sentence.style.minHeight = `${sentence.scrollHeight}px`;
  }

  // -- answers: { kind: "stage", ratio, width, height, legends } and its picture; { kind: "picture", … } and its points

  async function bitmap(bytes) {
    return bytes instanceof ImageBitmap ? bytes : createImageBitmap(new Blob([bytes], { type: "image/png" }));
  }
  async function take(message, buffers) {
    if (message.kind === "stage") {
      const image = await bitmap(buffers[0]);
      [canvas.width, canvas.height] = [below.width, below.height] = [message.width, message.height];
      below.getContext("2d").drawImage(image, 0, 0);
      state.stage = message;
      return;
    }
    const mine = message.view === view;
    if (message.epoch !== state.epoch) Object.assign(state, { epoch: message.epoch, next: null, asked: {} });
    if (mine && message.n) {
      state.waiting = Math.max(0, state.waiting - 1);
      send();
    }
    if (mine) watch();
    for (const name of all) {
      if (!mine || !message.n || !(state.asked[name] > message.n)) controls[name].set(message.values[name]);
    }
    say(message.status);
    if (state.stage && message.ratio === state.stage.ratio && message.ops) {
      const [points, ...files] = buffers;
      const numbers = new Float32Array(points.buffer.slice(points.byteOffset, points.byteOffset + points.byteLength));
      draw(message, numbers, files.length ? await Promise.all(files.map(bitmap)) : []);
    }
    el.dispatchEvent(new CustomEvent("kf-picture", { bubbles: true, detail: message.n }));
  }
  function draw(message, numbers, images) {
    const pen = canvas.getContext("2d");
    pen.drawImage(below, 0, 0);
    paint(pen, message, numbers, images);
    for (const side of state.stage.legends) pen.drawImage(below, ...side, ...side); // nothing moves over them
    message.handles.forEach((place, i) => put(handles[i], place, state.stage));
    canvas.setAttribute("aria-label", `${spec.text}. ${message.status}`);
  }
  const listen = (message, buffers) => (order = order.then(() => take(message, buffers)).catch(console.error));
  model.on("msg:custom", listen);

  async function begin(file) {
    const image = await bitmap(file);
    if (!state.stage) [canvas.width, canvas.height] = [image.width, image.height];
    if (!state.stage) canvas.getContext("2d").drawImage(image, 0, 0);
  }
  const first = model.get("first"); // the picture when the cell ran: until the kernel answers, and where there is none
  if (first?.byteLength) order = begin(first).catch(console.error);
  canvas.setAttribute("aria-label", spec.text);
  for (const { name, start } of spec.controls) controls[name].set(start);

  // -- how fine the screen is: asked again when the page is zoomed or moved to another screen

  function greet() {
    const ratio = Math.min(Math.max(window.devicePixelRatio || 1, 1), 3);
    if (ratio === state.ratio) return;
    state.ratio = ratio;
    tell({ kind: "hello", view, ratio });
    watch();
    state.screen?.removeEventListener("change", greet);
    state.screen = matchMedia(`(resolution: ${window.devicePixelRatio}dppx)`);
    state.screen.addEventListener("change", greet);
  }
  greet();
  return () => {
    model.off("msg:custom", listen);
    state.screen.removeEventListener("change", greet);
    [state.busy, state.lost, state.speak].forEach(clearTimeout);
  };
}

export default { render };
