/**
 * Parts of the screen that come in a file of their own: dialogs, menus, panels. The first screen stays
 * small, and all of them are fetched in the background once the page has time (`preloadParts`), so
 * that hardly anybody ever waits for one.
 *
 * When a file does not come (no network, a newer Corridor on the server), the part says so where it
 * would stand and can be asked for again; nothing else on the page is touched.
 */
import { useEffect, useSyncExternalStore, type ComponentType, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "./Button.tsx";
import { Dialog } from "./Dialog.tsx";
import styles from "./lazy-part.module.css";
import { PartLoader } from "./part-loader.ts";

const loaders = new Set<{ load: () => Promise<void> }>();

/** Fetches the parts that nobody has asked for yet, one after the other. What fails waits for its call. */
export async function preloadParts(): Promise<void> {
  for (const loader of loaders) await loader.load();
}

function loaderOf<Props>(load: () => Promise<ComponentType<Props>>) {
  const loader = new PartLoader(load);
  loaders.add(loader);
  return loader;
}

function useLoaded<Part>(loader: PartLoader<Part>, isWanted: boolean) {
  useEffect(() => {
    if (isWanted) void loader.load();
  }, [loader, isWanted]);
  return useSyncExternalStore(loader.listen, loader.state);
}

/**
 * A part that fills a place: a panel, the content of a menu.
 *
 * ```tsx
 * const PresetsPanel = lazyPart(async () => (await import("./PresetsPanel.tsx")).PresetsPanel);
 * ```
 */
export function lazyPart<Props extends object>(
  load: () => Promise<ComponentType<Props>>,
): ComponentType<Props> {
  const loader = loaderOf(load);
  return function LazyPart(props: Props) {
    const { t } = useTranslation();
    const state = useLoaded(loader, true);
    if (state.kind === "ready") return <state.part {...props} />;
    if (state.kind === "failed") return <PartFailure onRetry={() => void tryAgain(loader)} />;
    return <p className={styles["opening"]}>{t("offline.opening")}</p>;
  };
}

export interface WaitingProps {
  isWanted: boolean;
  children?: ReactNode;
}

/**
 * A part that can wait: it is fetched once it is wanted, or with all the others in the background. Until then
 * its children stand in its place, which must have a size of its own.
 */
export function waitingPart<Props extends object>(
  load: () => Promise<ComponentType<Props>>,
): ComponentType<Props & WaitingProps> {
  const loader = loaderOf(load);
  return function WaitingPart(props: Props & WaitingProps) {
    const { isWanted, children } = props;
    const state = useLoaded(loader, isWanted);
    if (state.kind === "ready") return <state.part {...props} />;
    if (state.kind === "failed" && isWanted) {
      return <PartFailure onRetry={() => void tryAgain(loader)} />;
    }
    return children;
  };
}

interface DialogProps {
  isOpen: boolean;
  onClose: () => void;
}

/** A part that is a dialog: it opens once its file is there; until then the screen stays as it is. */
export function lazyDialog<Props extends DialogProps>(
  load: () => Promise<ComponentType<Props>>,
): ComponentType<Props> {
  const loader = loaderOf(load);
  return function LazyDialog(props: Props) {
    const { t } = useTranslation();
    const { isOpen, onClose } = props;
    const state = useLoaded(loader, isOpen);
    if (state.kind === "ready") return <state.part {...props} />;
    return (
      <Dialog
        isOpen={isOpen && state.kind === "failed"}
        onClose={onClose}
        title={t("offline.partFailedTitle")}
        width="narrow"
      >
        <PartFailure onRetry={() => void tryAgain(loader)} />
      </Dialog>
    );
  };
}

/**
 * Browsers remember for as long as a page is open that a file did not come, and a newer Corridor does
 * not have this one's files: then only a reload helps. It is done where the service answers, so that
 * nobody loses the page to a network that is gone; the work is saved when the page is left.
 */
async function tryAgain(loader: PartLoader<unknown>): Promise<void> {
  await loader.load();
  if (loader.state().kind === "failed" && (await answers("/healthz"))) location.reload();
}

async function answers(address: string): Promise<boolean> {
  try {
    return (await fetch(address, { cache: "no-store" })).ok;
  } catch {
    return false;
  }
}

function PartFailure({ onRetry }: { onRetry: () => void }) {
  const { t } = useTranslation();
  return (
    <div role="alert" className={styles["failure"]}>
      <p>{t("offline.partFailed")}</p>
      <Button onClick={onRetry}>{t("offline.tryAgain")}</Button>
    </div>
  );
}
