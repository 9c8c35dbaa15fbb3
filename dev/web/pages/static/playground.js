// A playground without a kernel: all its pictures were made when the page was built; the controls choose among them.

for (const figure of document.querySelectorAll("figure.playground")) {
  const { text, start, together, frames } = JSON.parse(figure.querySelector("script").textContent);
  const [form, image, status] = ["form", "img", "[role=status]"].map((what) => figure.querySelector(what));
  const fields = [...form.querySelectorAll("input[type=range], fieldset")];
  const folder = image.getAttribute("src").replace(/[^/]*$/, "");
  const isSlider = (field) => field.type === "range";
  const place = (field) => Number(isSlider(field) ? field.value : field.querySelector(":checked").value);

  function show() {
    for (const slider of fields.filter(isSlider)) {
      const words = JSON.parse(slider.dataset.texts)[slider.value];
      slider.nextElementSibling.textContent = words;
      slider.setAttribute("aria-valuetext", words);
    }
    const [number, sentence] = frames[fields.map(place).join()];
    image.src = `${folder}${number}.webp`;
    image.alt = `${text}. ${sentence}`;
    status.textContent = sentence;
  }

  form.addEventListener("input", ({ target }) => {
    if (!together && isSlider(target))
      fields.forEach((field, i) => {
        if (isSlider(field) && field !== target) field.value = start[i];
      });
    show();
  });
  form.addEventListener("reset", () => setTimeout(show));
  form.addEventListener("submit", (event) => event.preventDefault());

  function fetchAll() {
    for (const number of new Set(Object.values(frames).map((frame) => frame[0])))
      new Image().src = `${folder}${number}.webp`;
  }
  const first = ["pointerover", "focusin"]; // whoever comes near will want them
  const once = () => (first.forEach((type) => figure.removeEventListener(type, once)), fetchAll());
  first.forEach((type) => figure.addEventListener(type, once));

  form.reset();
  form.hidden = false;
}

document.addEventListener("click", ({ target }) => {
  if (target.matches(".cell_output img, .playground img")) target.classList.toggle("large"); // on a phone: see course.css
});
