"""The page around a lesson's slides: its style, and nbconvert's template without what it would load from a network."""

STYLE = """<style>
.reveal { font-size: 24px; }
.reveal .slides { text-align: left; }
.reveal .slides > section > section { box-sizing: border-box; padding: 32px 48px 0; }
.reveal h1, .reveal h2 { font-size: 1.6em; text-transform: none; margin: 0 0 0.5em; }
.reveal .jp-Cell { padding: 0; }
.reveal p { margin: 0.5em 0; line-height: 1.4; }
.reveal li { line-height: 1.4; }
.reveal img { max-width: none; max-height: none; margin: 0; }
.reveal { --jp-code-font-size: 19px; --jp-code-line-height: 1.3; }
.reveal .celltag_small { --jp-code-font-size: 16px; }
.reveal pre { font-size: var(--jp-code-font-size); line-height: 1.3; white-space: pre; width: 100%; margin: 0.3em 0;
box-shadow: none; }
.reveal .jp-Cell-inputWrapper, .reveal .jp-RenderedHTMLCommon { font-size: 1em; }
.reveal .jp-InputPrompt, .reveal .jp-OutputPrompt, .reveal .jp-InputCollapser, .reveal .jp-OutputCollapser
{ display: none; }
.reveal table { font-size: 0.8em; }
.reveal .slide-number { right: auto; left: 8px; }
math[display="block"] { margin: 0.6em 0; }
</style>"""
# What nbconvert would load from a network is left out, and reveal.js started as it lies in the file.
TEMPLATE = """{% extends 'reveal/index.html.j2' %}
{% block html_head_js_jquery %}{% endblock %}
{% block html_head_js_requirejs %}{% endblock %}
{% block html_head_js_mermaidjs %}{% endblock %}
{% block html_head_js_mathjax %}{% endblock %}
{% block footer_js %}<script>
function fit({currentSlide}) {
  const bottom = element => element.getBoundingClientRect().bottom;
  const tooHigh = () => bottom(currentSlide.lastElementChild) > bottom(document.querySelector(".slides"));
  for (let zoom = 0.95; zoom > 0.4 && tooHigh(); zoom -= 0.05) currentSlide.style.zoom = zoom;
}
Reveal.on("ready", fit);
Reveal.on("slidechanged", fit);
Reveal.initialize({hash: true, center: false, controls: true, progress: true, slideNumber: "c/t", transition: "none",
                   width: 1280, height: 720, margin: 0});
</script>{% endblock %}"""
