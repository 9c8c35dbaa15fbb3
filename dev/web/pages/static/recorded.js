/* A playground on the web page: no kernel, but pictures that were recorded when the page was built (dev/web/frames.py).
build.py puts this script behind kflearn/ui/playground.js; `element`, `nearest` and `render` are defined there.

A page opened from a disk may not fetch files, but may load scripts: so each recording is a script that calls
window.recorded with a list of files in base64: what stays (WebP), the pictures (packed.py says how), images (WebP). */

// ---- what was recorded

const coming = new Map(); // by script element: who waits for its files

window.recorded = (files) => coming.get(document.currentScript)(files);

function files(source) {
  return new Promise((done, failed) => {
    const script = element("script", { src: source, onerror: () => failed(new Error(`${source} is not there`)) });
    coming.set(script, done);
    document.head.append(script);
  });
}

function bytesOf(text) {
  return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
}

async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function unpacked(bytes) {
  const length = new DataView(bytes.buffer).getUint32(0, true);
  const about = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
  const next = numbers(bytes, 4 + length);
  const rows = [[]];
  for (let i = 0; i < about.rows; i++) rows.push(Array.from({ length: next() }, (_, k) => (rows[i][k] ?? 0) + next()));
  const table = Array.from({ length: about.blocks }, () => [next(), next(), next()]);
  const blocks = [];
  for (const [kind, back, stepwise] of table) {
    const [count] = about.kinds[kind];
    const block = new Int32Array(2 * count);
    for (let i = 0; i < 2 * count; i++) block[i] = next() + (stepwise && i % count ? block[i - 1] : 0);
    if (back) blocks[blocks.length - back].forEach((value, i) => (block[i] += value));
    blocks.push(block);
  }
  return { about, rows: rows.slice(1), blocks, kinds: table.map(([kind]) => about.kinds[kind]) };
}

function numbers(bytes, at) {
  return () => {
    let found = 0;
    for (let times = 1; ; times *= 128) {
      const byte = bytes[at++];
      found += (byte & 127) * times;
      if (byte < 128) return found % 2 ? -(found + 1) / 2 : found / 2;
    }
  };
}

class Recording {
  constructor([still, pictures, ...images]) {
    Object.assign(this, pictures); // about, rows, blocks, kinds
    Object.assign(this, { still, images });
    this.numbers = new Map(this.about.settings.map((setting, number) => [setting.join(), number]));
  }

  static async load(source) {
    const [still, pictures, ...images] = (await files(source)).map(bytesOf);
    const bitmaps = [still, ...images].map((bytes) => createImageBitmap(new Blob([bytes], { type: "image/webp" })));
    const [first, ...others] = await Promise.all(bitmaps);
    return new Recording([first, unpacked(await inflated(pictures)), ...others]);
  }

  has(setting) {
    return this.numbers.has(setting.join());
  }

  row(setting) {
    return this.rows[this.numbers.get(setting.join())];
  }

  // A picture as playground.js takes it: a message, and its points and images.
  picture(setting) {
    const { about, images } = this;
    const [words, ...parts] = this.row(setting);
    const [status, ...told] = about.words[words];
    const drawn = parts.slice(0, parts.length - told.length);
    const points = new Float32Array(2 * drawn.reduce((sum, part) => sum + this.kinds[part][0], 0));
    const [ops, used] = [[], []];
    let first = 0;
    for (const part of drawn) {
      const [count, kind, ...rest] = this.kinds[part];
      this.blocks[part].forEach((value, i) => (points[2 * (first + (i % count)) + (i >= count)] = value / about.fineness));
      if (kind === "i") rest[0] = used.push(images[rest[0]]) - 1;
      const moved = rest.map((place) => (place.length < 4 ? [place[0] + first, ...place.slice(1)] : place));
      ops.push([kind, ...moved]);
      first += count;
    }
    const handles = told.map((about, i) => ({ ...about, ...this.handle(setting, i) }));
    return [{ status, handles, ops, styles: about.styles }, [points, ...used]];
  }

  // Where a handle is, and its area: kept as three points.
  handle(setting, i) {
    const row = this.row(setting);
    const told = this.about.words[row[0]].slice(1);
    const block = this.blocks[row[row.length - told.length + i]];
    const [x, left, width, y, top, height] = Array.from(block, (value) => value / this.about.fineness);
    return { at: [x, y], area: [left, top, width, height], hidden: told[i].hidden };
  }
}

// ---- the model: what playground.js speaks to

const BESIDES = {
  busy: "The recorded pictures are on their way.",
  lost: "The recorded pictures do not come. Load the page again.",
};

class Model {
  constructor({ spec, start, status }, load, shown) {
    Object.assign(this, { spec: { ...spec, ...BESIDES }, start, status, load, shown, listeners: new Set() });
    this.setting = start;
    const isSlider = (i) => spec.controls[i].kind === "slider";
    this.order = [...spec.controls.keys()].filter(isSlider); // the one that was moved longest ago comes first
  }

  get(name) {
    return this[name];
  }
  on(_, listener) {
    this.listeners.add(listener);
  }
  off(_, listener) {
    this.listeners.delete(listener);
  }
  tell(message, buffers = []) {
    return Promise.all([...this.listeners].map((listener) => listener(message, buffers)));
  }

  send(content) {
    if (content.kind === "move") this.move(content).catch(console.error);
    else this.greet(content).catch(console.error);
  }

  // The values at once; the picture when there is one.
  async greet({ view, ratio }) {
    this.ratio = ratio;
    this.answer({ view, n: 0 }, [{ status: this.status, handles: [] }, []]);
    if (this.recording) await this.draw(view);
  }
  async draw(view) {
    const { width, height, legends } = this.recording.about;
    this.tell({ kind: "stage", ratio: this.ratio, width, height, legends }, [this.recording.still]);
    await this.answer({ view, n: 0 }, this.recording.picture(this.setting));
    this.shown();
  }
  async come() {
    this.loading ??= this.load();
    this.recording ??= await this.loading;
  }
  async show() {
    await this.come();
    await this.draw("");
  }

  async move(content) {
    await this.come();
    this.setting = this.allowed(this.wanted(content));
    const picture = this.recording.picture(this.setting);
    this.status = picture[0].status;
    await this.answer(content, picture);
  }
  answer({ view, n }, [message, buffers]) {
    const values = this.spec.controls.map((control, i) => [control.name, control.places[this.setting[i]]]);
    const about = { kind: "picture", view, n, epoch: 0, ratio: this.ratio, values: Object.fromEntries(values) };
    return this.tell({ ...about, ...message }, buffers);
  }

  // -- which setting

  wanted({ values = {}, drag, nudge, reset }) {
    if (reset) return [...this.start];
    const setting = [...this.setting];
    this.spec.controls.forEach((control, i) => {
      if (!(control.name in values)) return;
      setting[i] = nearest(control, values[control.name]);
      this.touched([i]);
    });
    if (drag) return this.dragged(setting, ...drag);
    if (nudge) return this.nudged(setting, ...nudge);
    return setting;
  }
  touched(moved) {
    const sliders = moved.filter((i) => this.order.includes(i));
    this.order = [...this.order.filter((i) => !sliders.includes(i)), ...sliders];
  }

  // Where not all sliders were recorded together, those moved longest ago go back to their start.
  allowed(setting) {
    const found = [...setting];
    for (const i of this.order) {
      if (this.recording.has(found)) break;
      found[i] = this.start[i];
    }
    return found;
  }

  // All recorded settings that a handle reaches from here.
  reach(setting, handle) {
    const { controls, handles } = this.spec;
    const own = handles[handle].map((name) => controls.findIndex((control) => control.name === name));
    this.touched(own);
    const [here, full] = [[...setting], own.reduce((product, i) => product * controls[i].places.length, 1)];
    const others = this.order.filter((i) => !own.includes(i));
    for (;;) {
      const same = (recorded) => recorded.every((place, i) => own.includes(i) || place === here[i]);
      const found = this.recording.about.settings.filter(same);
      if (found.length === full || !others.length) return found;
      const oldest = others.shift();
      here[oldest] = this.start[oldest];
    }
  }
  closest(settings, handle, [x, y], otherwise) {
    let [best, least] = [otherwise, Infinity];
    for (const setting of settings) {
      const { at, hidden } = this.recording.handle(setting, handle);
      const distance = hidden ? Infinity : Math.hypot(at[0] - x, at[1] - y);
      if (distance < least) [best, least] = [setting, distance];
    }
    return best;
  }
  dragged(setting, handle, x, y) {
    return this.closest(this.reach(setting, handle), handle, [x, y], setting);
  }
  nudged(setting, handle, right, down) {
    const [x, y] = this.recording.handle(this.allowed(setting), handle).at;
    const ahead = this.reach(setting, handle).filter((other) => {
      const { at } = this.recording.handle(other, handle);
      return (at[0] - x) * right + (at[1] - y) * down > 0.5;
    });
    const step = this.recording.about.width / 100;
    return this.closest(ahead, handle, [x + step * right, y + step * down], setting);
  }
}

// ---- the page

function live(figure, observer) {
  const told = JSON.parse(figure.querySelector("script").textContent);
  const [home, image] = [figure.querySelector("div"), figure.querySelector("img")];
  const model = new Model(told, () => Recording.load(figure.dataset.recorded), () => image.remove());
  render({ model, el: home });
  const picture = home.querySelector(".kf-picture");
  const shelf = element("div", { class: "kf-shelf" }); // in which a large picture scrolls
  picture.replaceWith(shelf);
  shelf.append(picture);
  picture.append(image); // until the canvas is drawn
  figure.comes = () => model.show().catch(console.error);
  observer.observe(figure);
}

const observer = new IntersectionObserver(
  (seen) => {
    for (const { isIntersecting, target } of seen) {
      if (!isIntersecting) continue;
      observer.unobserve(target);
      target.comes();
    }
  },
  { rootMargin: "400px" },
);
if ("DecompressionStream" in window) {
  for (const figure of document.querySelectorAll("figure.playground")) live(figure, observer);
}
