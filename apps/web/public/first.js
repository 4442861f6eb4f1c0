// Runs before the page's own script: sets theme, contrast and language before the first paint, and
// starts the simulator worker. On a first visit it also connects the Run button of the static page
// in index.html. It is a separate file because the Content-Security-Policy forbids inline scripts.
// src/model/preferences and src/shell/boot take over.
(() => {
  // The default Trusted Types policy: the browser calls it for each script address, and it permits
  // only Corridor's own scripts.
  window.trustedTypes?.createPolicy("default", {
    createScriptURL: (address) => {
      const { origin, pathname } = new URL(address, location);
      const isOurs = /^\/(sw|assets\/[\w.-]+)\.js$/.test(pathname);
      return origin === location.origin && isOurs ? address : null;
    },
  });
  const root = document.documentElement;
  const { simulator, page, words } = document.currentScript.dataset;
  /** Reads from storage, which the browser may forbid; then the result is null. */
  const ask = (read) => {
    try {
      return read();
    } catch {
      return null;
    }
  };
  // In a frame of another site, the page reads and stores nothing on this device.
  const isEmbedded = location.pathname.startsWith("/embed");
  if (isEmbedded) {
    const get = () => {
      throw new Error("blocked");
    };
    for (const name of ["localStorage", "sessionStorage"]) {
      Object.defineProperty(window, name, { get });
    }
  }
  const stored = (key) => ask(() => localStorage.getItem(`corridor.${key}`));

  const asksFor = (feature) => matchMedia(`(prefers-${feature})`).matches;
  let theme = stored("theme");
  if (theme !== "light" && theme !== "dark") {
    theme = asksFor("color-scheme: dark") ? "dark" : "light";
  }
  const isStrong = stored("contrast") === "more" || asksFor("contrast: more");
  Object.assign(root.dataset, { theme, contrast: isStrong ? "more" : "normal" });

  /** The texts below, by language. */
  const catalogues = JSON.parse(words || '{"en":{}}');
  const writing = (tag) =>
    ask(() => {
      const { language, script } = new Intl.Locale(tag).maximize();
      return `${language}-${script}`;
    });
  const tags = Object.keys(catalogues);
  // "en-GB" is English without a lookup. Only other tags use Intl, whose initialization takes
  // milliseconds.
  const find = (tag) => {
    const [, language] = /^([a-z]{2})(-[A-Z]{2})?$/.exec(tag) ?? [];
    if (tags.includes(language)) return language;
    return tag ? tags.find((each) => writing(each) === writing(tag)) : undefined;
  };
  const lang = [
    new URLSearchParams(location.search).get("lang"),
    stored("language"),
    ...navigator.languages,
    "en",
  ].reduce((found, tag) => found ?? find(tag), undefined);
  Object.assign(root, { lang, dir: lang === "ar" ? "rtl" : "ltr" });

  // Without the page's script, or without texts, only the English of index.html is available.
  window.corridorFailed = (...words) => {
    const [alert] = document.getElementById("failed").content.children;
    if (words.length > 0) alert.lang = alert.dir = "";
    words.forEach((text, at) => (alert.children[at].textContent = text));
    alert.lastElementChild.onclick = () => location.reload();
    document.getElementById("root").replaceChildren(alert);
  };

  // Only a build has the addresses; in development the page starts both itself.
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
  // On a first visit the worker's name contains its input, so that it starts without a message of
  // the page.
  const name = isFirst ? JSON.stringify([text.maze, text.program]) : "";
  // The pages of viewers, teachers and other sites start no simulator, or their own.
  const isOther = isEmbedded || /^\/(r\/|teach|class)/.test(location.pathname);
  const worker = isOther ? {} : new Worker(simulator, { type: "module", name });
  const early = { worker, queue: [], failure: null };
  window.corridorSimulator = early;
  let isPressed = false;
  // Parsing a script occupies a core, which delays the worker's start. On a first visit the browser
  // therefore fetches the page's script after 100 ms, or as soon as the page opens.
  const fetchPage = () => document.head.append(document.getElementById("parts").content);
  if (isFirst) setTimeout(fetchPage, 100);
  else fetchPage();
  let open = () => {
    open = () => {};
    fetchPage();
    import(page).catch(() => window.corridorFailed());
  };
  // The browser paints the static page before the page's script runs. After a press of Run the
  // robot starts first. The timeouts cover a hidden page, which paints nothing, and a robot that
  // fails to start.
  document.addEventListener("DOMContentLoaded", () => {
    // The static page has a bar, which a frame has not.
    if (isEmbedded) document.getElementById("root").replaceChildren();
    if (!isPressed) requestAnimationFrame(() => setTimeout(() => open()));
    setTimeout(() => open(), isPressed ? 1000 : 300);
  });
  worker.onerror = (event) => {
    // A file that fails to load has no message.
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
    // The last element of index.html: the static page is complete.
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
    // A visitor who has opened or dismissed the lessons is not invited again.
    root.dataset.first = stored("lessons") === null ? "invited" : "";
  });
  watch.observe(document, { childList: true, subtree: true });
})();
