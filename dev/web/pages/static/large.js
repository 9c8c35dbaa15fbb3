// On a phone a tap makes a picture as large as it is, and another one small again: see course.css.

document.addEventListener("click", ({ target }) => {
  if (target.matches(".cell_output img:not(.playground *)")) target.classList.toggle("large");
  if (target.matches(".kf-picture > :is(canvas, img)")) target.parentElement.classList.toggle("large");
});
