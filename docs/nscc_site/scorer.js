// The order of search results: the pages of single messages come after all other pages.
// Sphinx reads the other values, its own defaults, from here, too.
var Scorer = {
  score: ([docname, , , , score]) => (docname.startsWith("docs/generated/messages/") ? score - 1000 : score),
  objNameMatch: 11,
  objPartialMatch: 6,
  objPrio: { 0: 15, 1: 5, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
};
