// The search: a lesson that teaches a term comes before the pages that only mention it, and the place where an equation
// is derived before both. Sphinx calls `score` for each page it has found; teaches.py puts the glossary's terms in here,
// each with the pages of its lessons. The equations are entries of Sphinx's index, which conf.py makes.

var Scorer = {
  // Sphinx's own numbers
  objNameMatch: 11,
  objPartialMatch: 6,
  objPrio: { 0: 15, 1: 5, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,

  taught: TAUGHT, // "consider filter" → "21-consider-filter", …
  extra: {}, // query → page → points

  score: ([page, , , , score, , kind]) => {
    const query = new URLSearchParams(window.location.search).get("q") || "";
    Scorer.extra[query] ??= Scorer.points(query);
    if (kind === "index") return score === 100 ? 500 : score; // an equation, asked for by its whole name or by a part
    return score + (Scorer.extra[query].get(page) || 0);
  },

  // For a term asked for exactly 200, for a longer term with these words 100, a little less for its second lesson.
  points: (query) => {
    const stem = (text) => splitQuery(text.toLowerCase()).map((word) => new Stemmer().stemWord(word));
    const asked = stem(query);
    const points = new Map();
    for (const [term, pages] of Scorer.taught) {
      const words = stem(term);
      if (!asked.length || !asked.every((word) => words.includes(word))) continue;
      const most = asked.length === words.length ? 200 : 100 - words.length;
      pages.forEach((page, i) => points.set(page, Math.max(points.get(page) || 0, most - 10 * i)));
    }
    return points;
  },
};
