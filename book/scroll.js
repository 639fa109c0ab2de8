// What is wider than the page scrolls, and what scrolls can be reached with the keys.
(() => {
  "use strict";
  const wide = document.querySelectorAll("main :is(pre, figure.raystep, .table-wrapper, .raystep-formula)");
  const mark = () => {
    for (const element of wide) {
      if (element.clientWidth < element.scrollWidth) {
        element.tabIndex = 0;
      } else {
        element.removeAttribute("tabindex");
      }
    }
  };
  addEventListener("load", mark);
  addEventListener("resize", mark);
  // an answer that is unfolded may hold one
  document.addEventListener("toggle", mark, true);
})();
