// On a phone a tap makes a picture as large as it is, and another one small again: see course.css.

document.addEventListener("click", ({ target }) => {
  if (target.matches(".cell_output img:not(.playground *)")) target.classList.toggle("large");
  if (target.matches(".kf-picture > :is(canvas, img)")) target.parentElement.classList.toggle("large");
});

// Code, tables and formulas that are wider than the page can be scrolled with keys too: Tab goes there.

const wide = new ResizeObserver((all) => {
  for (const { target } of all) {
    if (target.scrollWidth > target.clientWidth) target.tabIndex = 0;
    else target.removeAttribute("tabindex");
  }
});
for (const part of document.querySelectorAll("pre, .table-wrapper, .formulas > div")) wide.observe(part);
