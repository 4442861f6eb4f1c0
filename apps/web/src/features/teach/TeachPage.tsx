/** The frame of the pages for teachers: the bar, and the view that the address names. */
import { useEffect, useRef, useState, useSyncExternalStore, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import type { KeyValueStorage } from "../../model/storage/key-value-storage.ts";
import { Brand } from "../../ui/Brand.tsx";
import { ErrorBoundary } from "../../ui/ErrorBoundary.tsx";
import { lazyPart } from "../../ui/lazy-part.tsx";
import { TeachHome } from "./TeachHome.tsx";
import { teachViewOf } from "./teach-view.ts";
import styles from "./teach.module.css";

const HandIns = lazyPart(async () => (await import("./HandIns.tsx")).HandIns);
const ReportView = lazyPart(async () => (await import("./report/ReportView.tsx")).ReportView);

const titles = {
  home: "teach:title",
  "hand-ins": "teach:handIns.pageTitle",
  lesson: "teach:handIns.pageTitle",
  report: "report:pageTitle",
} as const;

interface TeachPageProps {
  /** localStorage */
  device: KeyValueStorage;
  /** the buttons for theme and language */
  tools: ReactNode;
}

export function TeachPage({ device, tools }: TeachPageProps) {
  const { t, i18n } = useTranslation(["teach", "report", "words"], { useSuspense: false });
  const hash = useSyncExternalStore(listenToAddress, () => location.hash);
  const view = teachViewOf(hash);
  const title = t(titles[view.name]);
  useEffect(() => {
    document.title = title;
  }, [title, i18n.language]);
  const main = useFocusOnChange(view.name === "home");
  return (
    <ErrorBoundary onError={() => undefined}>
      <div className={styles["page"]}>
        <header className={styles["bar"]}>
          <a
            className={styles["skip"]}
            href="#main"
            onClick={(event) => {
              // The fragment of the address names the view.
              event.preventDefault();
              main.current?.focus();
            }}
          >
            {t("teach:skip")}
          </a>
          <a className={styles["brand"]} href="/">
            <Brand />
          </a>
          <a className={styles["here"]} href="/teach" aria-label={t("teach:all")}>
            {t("teach:teach")}
          </a>
          <div className={styles["end"]}>{tools}</div>
        </header>
        <main ref={main} id="main" className={styles["main"]} tabIndex={-1}>
          {view.name === "home" && <TeachHome />}
          {view.name === "report" && <ReportView />}
          {(view.name === "hand-ins" || view.name === "lesson") && (
            <HandIns device={device} link={view.name === "lesson" ? view.link : null} />
          )}
        </main>
      </div>
    </ErrorBoundary>
  );
}

function listenToAddress(changed: () => void): () => void {
  window.addEventListener("hashchange", changed);
  return () => window.removeEventListener("hashchange", changed);
}

/** Moves the focus to the content when another view opens, as a new page would. */
function useFocusOnChange(key: unknown) {
  const main = useRef<HTMLElement>(null);
  const [first] = useState(key);
  const isFirst = useRef(true);
  useEffect(() => {
    if (isFirst.current && key === first) {
      isFirst.current = false;
      return;
    }
    main.current?.focus();
  }, [key, first]);
  return main;
}
