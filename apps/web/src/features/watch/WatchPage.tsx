/** The page of a viewer: the robot in its maze, its state and its readings, without controls. */
import { Eye } from "lucide";
import { useEffect, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { Brand } from "../../ui/Brand.tsx";
import { ErrorBoundary } from "../../ui/ErrorBoundary.tsx";
import { Icon } from "../../ui/Icon.tsx";
import { classNames } from "../../ui/class-names.ts";
import buttons from "../../ui/button.module.css";
import type { WatchClient } from "./watch-client.ts";
import { endingOf, type WatchStore } from "./watch-store.ts";
import { WatchEnding } from "./WatchEnding.tsx";
import { WatchPanel } from "./WatchPanel.tsx";
import { WatchStage } from "./WatchStage.tsx";
import styles from "./watch.module.css";

interface WatchPageProps {
  store: WatchStore;
  /** the buttons for theme and language */
  tools: ReactNode;
  /** null while there is nothing to watch */
  client: () => WatchClient | null;
}

export function WatchPage({ store, tools, client }: WatchPageProps) {
  const { t } = useTranslation(["words", "watch"], { useSuspense: false });
  const ending = useStore(store, endingOf);
  const title = t("watch:title");
  useEffect(() => {
    document.title = title;
  }, [title]);
  const isWatching = ending === null;
  const drawer = client();
  return (
    <ErrorBoundary onError={() => undefined}>
      <div className={styles["page"]} data-ends={!isWatching}>
        <header className={styles["bar"]}>
          <Brand />
          {isWatching && (
            <p className={styles["banner"]}>
              <Icon of={Eye} />
              {t("watch:watching")}
            </p>
          )}
          <div className={styles["end"]}>
            {tools}
            {isWatching && (
              <a
                className={classNames(buttons["button"], buttons["outline"], buttons["medium"])}
                href="/"
              >
                {t("watch:open")}
              </a>
            )}
          </div>
        </header>
        {ending === null && drawer !== null ? (
          <>
            <WatchStage store={store} client={drawer} />
            <WatchPanel store={store} client={drawer} />
          </>
        ) : (
          <WatchEnding ending={ending ?? "failed"} />
        )}
      </div>
    </ErrorBoundary>
  );
}
