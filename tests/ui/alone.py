"""A playground in Chromium without Jupyter: its messages are carried by hand, so that a test can hold them back.

alone = Alone(chromium, make(), ratio=2)
alone.slider(0).press("ArrowRight")
alone.carry()                            # now the kernel's side hears of it, and answers
"""

import base64

from dev.canvas import SCRIPT

START = """async ([script, spec, views]) => {
  Object.assign(window, { sent: [], most: 0, listeners: [], ends: [] });
  const { render } = await import(`data:text/javascript;base64,${script}`);
  const off = (_, listener) => (listeners = listeners.filter(each => each !== listener));
  const send = content => { sent.push(content); most = Math.max(most, sent.length) };
  const model = { get: name => ({ spec })[name], send, on: (_, listener) => listeners.push(listener), off };
  for (let i = 0; i < views; i++) {
    const el = document.createElement("div");
    document.querySelector("main").append(el);
    ends.push(render({ model, el }));
  }
}"""

GIVE = """async ([content, buffers]) => {
  const drawn = new Promise(done => {
    let left = listeners.length;
    document.addEventListener("kf-picture", function count() {
      left -= 1;
      if (left) return;
      document.removeEventListener("kf-picture", count);
      done();
    });
  });
  const views = buffers.map(text => new DataView(Uint8Array.from(atob(text), sign => sign.charCodeAt(0)).buffer));
  listeners.forEach(listen => listen(content, views));
  if (content.kind === "picture") await drawn;
}"""

HTML = (
    "<!doctype html><html lang=en><title>A playground</title><style>body {{ margin: 8px }} {css}</style><main></main>"
)


class Alone:
    """A page with one playground, in one view or several."""

    def __init__(self, chromium, lively, views=1, ratio=1, patience=None, **how):
        how = dict(viewport=dict(width=1000, height=800), device_scale_factor=ratio) | how
        self.lively, self.faults = lively, []
        self.page = chromium.new_context(**how).new_page()
        self.page.set_default_timeout(20_000)
        self.page.on("console", lambda message: message.type == "error" and self.faults.append(message.text))
        self.page.on("pageerror", lambda error: self.faults.append(str(error)))
        self.page.set_content(HTML.format(css=SCRIPT.with_suffix(".css").read_text(encoding="utf-8")))
        lively.widget.send = self.hear
        spec = dict(lively.widget.spec) | ({"patience": patience} if patience else {})
        script = base64.b64encode(SCRIPT.read_bytes()).decode()
        self.page.evaluate(START, [script, spec, views])
        self.carry()

    def hear(self, content, buffers=None):
        """The kernel's side says something: the page hears it, and has drawn it when this returns."""
        files = [base64.b64encode(buffer).decode() for buffer in buffers or []]
        self.page.evaluate(GIVE, [content, files])

    def carry(self):
        """Answer what the page has said, until it says nothing more; returns the messages."""
        carried = []
        while messages := self.page.evaluate("sent.splice(0)"):
            for content in messages:
                self.lively.widget._handle_custom_msg(content, [])
            carried += messages
        return carried

    def close(self):
        """Close the page; fails where something went wrong in it."""
        self.page.context.close()
        assert not self.faults, self.faults

    # -- hands and eyes

    def slider(self, index=0):
        return self.page.locator("input[type=range]").nth(index)

    def box(self, index=0):
        return self.page.locator(".kf-box").nth(index)

    def handle(self, index=0):
        return self.page.locator(".kf-handle").nth(index)

    def type(self, index, text):
        self.box(index).fill(text)
        self.box(index).press("Enter")
        self.carry()

    def drag(self, place, right, down, steps=8, carry=True):
        """Take something by its middle and move it by so many pixels of the page, with the mouse."""
        box = place.bounding_box()
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        self.page.mouse.move(x, y)
        self.page.mouse.down()
        for step in range(1, steps + 1):
            self.page.mouse.move(x + right * step / steps, y + down * step / steps)
            if carry:
                self.carry()
        self.page.mouse.up()

    def numbers(self):
        """What stands in the boxes."""
        return [float(text) for text in self.page.locator(".kf-box").evaluate_all("all => all.map(i => i.value)")]

    def sentence(self):
        return self.page.locator(".kf-sentence").first.inner_text()

    def picture(self, index=0):
        """The canvas as it is now: the text of a PNG file."""
        return self.page.locator(".kf-picture canvas").nth(index).evaluate("canvas => canvas.toDataURL()")

    def is_right(self):
        """The page shows what the kernel's side gives: numbers, sentence, and the same picture when made again."""
        before = self.picture()
        self.lively.refresh()
        values = [value for value in self.lively.values.values() if not isinstance(value, str | bool)]
        assert self.numbers() == values
        assert self.sentence() == self.lively.status
        return self.picture() == before
