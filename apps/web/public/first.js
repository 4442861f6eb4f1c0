// What cannot wait for the page's own script: theme, contrast and language, before the first paint; the
// simulator worker, which gets ready while that script is still on its way; and, on a first visit, Run in
// the house that index.html draws. A file of its own, since the page's Content-Security-Policy forbids
// inline scripts. src/app/theme.ts, language.ts and simulator-start.ts take over.
(() => {
  // Asked by the browser wherever a script is started by its address: ours alone are (Trusted Types).
  window.trustedTypes?.createPolicy("default", {
    createScriptURL: (address) => {
      const { origin, pathname } = new URL(address, location);
      const isOurs = /^\/(sw|assets\/[\w.-]+)\.js$/.test(pathname);
      return origin === location.origin && isOurs ? address : null;
    },
  });
  const root = document.documentElement;
  const { simulator, page, words } = document.currentScript.dataset;
  /** Storage may be forbidden: then nothing is kept. */
  const ask = (read) => {
    try {
      return read();
    } catch {
      return null;
    }
  };
  const kept = (key) => ask(() => localStorage.getItem(`corridor.${key}`));

  const asksFor = (wish) => matchMedia(`(prefers-${wish})`).matches;
  let theme = kept("theme");
  if (theme !== "light" && theme !== "dark") {
    theme = asksFor("color-scheme: dark") ? "dark" : "light";
  }
  const isStrong = kept("contrast") === "more" || asksFor("contrast: more");
  Object.assign(root.dataset, { theme, contrast: isStrong ? "more" : "normal" });

  /** The words of the few things below, by language. */
  const catalogues = JSON.parse(words || '{"en":{}}');
  const writing = (tag) =>
    ask(() => {
      const { language, script } = new Intl.Locale(tag).maximize();
      return `${language}-${script}`;
    });
  const tags = Object.keys(catalogues);
  // "en-GB" is English, wherever that is read: only the rest asks Intl, which takes milliseconds to wake.
  const find = (wish) => {
    const [, language] = /^([a-z]{2})(-[A-Z]{2})?$/.exec(wish) ?? [];
    if (tags.includes(language)) return language;
    return wish ? tags.find((tag) => writing(tag) === writing(wish)) : undefined;
  };
  const lang = [
    new URLSearchParams(location.search).get("lang"),
    kept("language"),
    ...navigator.languages,
    "en",
  ].reduce((found, wish) => found ?? find(wish), undefined);
  Object.assign(root, { lang, dir: lang === "ar" ? "rtl" : "ltr" });

  // Without the page's script, or without words, the English of index.html is all that can be said.
  window.corridorFailed = (...words) => {
    const [alert] = document.getElementById("failed").content.children;
    if (words.length > 0) alert.lang = alert.dir = "";
    words.forEach((text, at) => (alert.children[at].textContent = text));
    alert.lastElementChild.onclick = () => location.reload();
    document.getElementById("root").replaceChildren(alert);
  };

  // The addresses are there in a build; while Corridor is developed the page starts both by itself.
  if (!simulator) return;
  const text = catalogues[lang];
  const isFirst =
    location.pathname === "/" &&
    location.hash.length < 2 &&
    !ask(
      () =>
        sessionStorage.getItem("corridor.run") ||
        Object.keys(localStorage).some((key) => /^corridor\.(work|aside)\./.test(key)),
    );
  // A name needs no message, which would wait for the page: the worker begins by itself.
  const name = isFirst ? JSON.stringify([text.maze, text.program]) : "";
  // Whoever looks on at another page's robot needs none here.
  const isWatch = location.pathname.startsWith("/r/");
  const worker = isWatch ? {} : new Worker(simulator, { type: "module", name });
  const early = { worker, queue: [], failure: null };
  window.corridorSimulator = early;
  let isPressed = false;
  // A script is read as soon as it arrives, which takes a core away from the worker that starts meanwhile:
  // on a first visit the page's comes after the first tick, or, on a slow line, long before that.
  const fetchPage = () => document.head.append(document.getElementById("parts").content);
  if (isFirst) setTimeout(fetchPage, 100);
  else fetchPage();
  let open = () => {
    open = () => {};
    fetchPage();
    import(page).catch(() => window.corridorFailed());
  };
  // The house is painted before the rest of the page is run; who has pressed Run already sees the robot
  // start first. A hidden page paints nothing, and a robot may fail to start.
  document.addEventListener("DOMContentLoaded", () => {
    if (!isPressed) requestAnimationFrame(() => setTimeout(() => open()));
    setTimeout(() => open(), isPressed ? 1000 : 300);
  });
  worker.onerror = (event) => {
    // A file that does not come has no message.
    early.failure = String(event.message ?? "");
    open();
  };
  const buttons = () => [...document.querySelectorAll("[data-early] > * > button")];
  worker.onmessage = ({ data }) => {
    early.queue.push(data);
    if (data.type !== "frame") return;
    const { state, tick } = data.frame.snapshot;
    const hadFocus = buttons().includes(document.activeElement);
    for (const button of buttons()) {
      button.hidden = (button.dataset.does === "pause") !== (state === "running");
      if (hadFocus && !button.hidden) button.focus();
    }
    if (tick > 0) open();
  };
  if (!isFirst) return;

  const watch = new MutationObserver(() => {
    // The last thing in the document: the house is there.
    if (document.getElementById("wordmark") === null) return;
    watch.disconnect();
    document.querySelector("[data-early]").setAttribute("aria-label", text.controls);
    const { content } = document.getElementById("invitation");
    for (const place of document.querySelectorAll("[data-invites]")) {
      place.append(content.cloneNode(true));
    }
    for (const each of document.querySelectorAll("[data-word]")) {
      each.append(text[each.dataset.word]);
    }
    for (const button of buttons()) {
      button.onclick = () => {
        isPressed = true;
        worker.postMessage({ type: button.dataset.does });
      };
    }
    // Who has seen the lessons, or does not want them, is not invited again.
    root.dataset.first = kept("lessons") === null ? "invited" : "";
  });
  watch.observe(document, { childList: true, subtree: true });
})();
