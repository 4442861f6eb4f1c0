/** The page on which a student joins a class: the letters on the board, then the student's name. */
import type { JoinedClass } from "@corridor/protocol";
import { useEffect, useState, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { storedMembership, storeMembership } from "../../model/classes/membership.ts";
import type { KeyValueStorage } from "../../model/storage/key-value-storage.ts";
import { Brand } from "../../ui/Brand.tsx";
import { ErrorBoundary } from "../../ui/ErrorBoundary.tsx";
import { classNames } from "../../ui/class-names.ts";
import { JoinedClassCard } from "./JoinedClassCard.tsx";
import { JoinForm } from "./JoinForm.tsx";
import layout from "../../ui/page.module.css";
import styles from "./join.module.css";

interface JoinPageProps {
  /** sessionStorage */
  tab: KeyValueStorage;
  /** the buttons for theme and language */
  tools: ReactNode;
}

export function JoinPage({ tab, tools }: JoinPageProps) {
  const { t, i18n } = useTranslation("join", { useSuspense: false });
  const [code, setCode] = useState(codeOfAddress);
  // A code in the address is for a class that this tab may not have joined yet.
  const [joined, setJoined] = useState(() => (code === "" ? storedMembership(tab) : null));
  useEffect(() => {
    // Another code in the address bar does not reload the page.
    const follow = (): void => {
      if (codeOfAddress() === "") return;
      setCode(codeOfAddress());
      setJoined(null);
    };
    window.addEventListener("hashchange", follow);
    return () => window.removeEventListener("hashchange", follow);
  }, []);
  useEffect(() => {
    document.title = t("pageTitle");
  }, [t, i18n.language]);
  const enter = (next: JoinedClass): void => {
    storeMembership(tab, next);
    // A reload must not join the class again as another student.
    history.replaceState(history.state, "", location.pathname + location.search);
    setJoined(next);
  };
  return (
    <ErrorBoundary onError={() => undefined}>
      <div className={layout["page"]}>
        <header className={layout["bar"]}>
          <a className={layout["brand"]} href="/">
            <Brand />
          </a>
          <div className={layout["end"]}>{tools}</div>
        </header>
        <main className={classNames(layout["main"], styles["main"])}>
          {joined === null ? (
            <JoinForm key={code} code={code} onJoin={enter} />
          ) : (
            <JoinedClassCard joined={joined} onRename={enter} />
          )}
        </main>
      </div>
    </ErrorBoundary>
  );
}

function codeOfAddress(): string {
  return location.hash.slice(1);
}
