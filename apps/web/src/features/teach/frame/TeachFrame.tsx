/** The frame of the pages for teachers: the bar and the content. */
import { useEffect, type ReactNode, type RefObject } from "react";
import { useTranslation } from "react-i18next";
import { Brand } from "../../../ui/Brand.tsx";
import { classNames } from "../../../ui/class-names.ts";
import layout from "../../../ui/page.module.css";
import styles from "./teach.module.css";

interface TeachFrameProps {
  /** title of the document */
  title: string;
  /** in the bar, in place of the link to the start page */
  bar?: ReactNode;
  /** at the end of the bar */
  end: ReactNode;
  /** receives the focus when another view opens */
  main: RefObject<HTMLElement | null>;
  /** whether the content fills the window, without a margin */
  isFull?: boolean;
  children: ReactNode;
}

export function TeachFrame({ title, bar, end, main, isFull = false, children }: TeachFrameProps) {
  const { t, i18n } = useTranslation(["teach", "words"], { useSuspense: false });
  useEffect(() => {
    document.title = title;
  }, [title, i18n.language]);
  return (
    <div className={classNames(layout["page"], styles["page"])} data-full={isFull}>
      <header className={classNames(layout["bar"], styles["bar"])}>
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
        <a className={layout["brand"]} href="/">
          <Brand />
        </a>
        {bar ?? (
          <a className={styles["here"]} href="/teach" aria-label={t("teach:all")}>
            {t("teach:teach")}
          </a>
        )}
        <div className={layout["end"]}>{end}</div>
      </header>
      <main
        ref={main}
        id="main"
        className={classNames(layout["main"], styles["main"])}
        tabIndex={-1}
      >
        {children}
      </main>
    </div>
  );
}
