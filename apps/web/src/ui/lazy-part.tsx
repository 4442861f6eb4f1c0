/**
 * Parts of the screen in files of their own: dialogs, menus, panels. The first screen stays small,
 * and `preloadParts` loads them all in the background once the page is idle, so that users hardly
 * ever wait for one.
 *
 * If a file does not load (no network, a newer Corridor on the server), the part shows an error in
 * its place with a button to retry. Nothing else on the page is affected.
 */
import { useEffect, useSyncExternalStore, type ComponentType, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "./Button.tsx";
import { Dialog } from "./Dialog.tsx";
import styles from "./lazy-part.module.css";
import { PartLoader } from "./part-loader.ts";

declare global {
  interface Navigator {
    /** Network Information API, https://wicg.github.io/netinfo/; only in Chromium */
    readonly connection?: { readonly saveData: boolean };
  }
}

interface Preloaded {
  load: () => Promise<void>;
  /** whether the part appears by itself, rather than when the user opens it */
  appears: boolean;
}

const preloaded = new Set<Preloaded>();

/**
 * Loads the parts that were not requested yet, one after the other. A failed one loads when it is
 * requested. So does a part that the user opens, if the user asked the browser to save data.
 */
export async function preloadParts(): Promise<void> {
  const savesData = navigator.connection?.saveData === true;
  for (const part of preloaded) if (part.appears || !savesData) await part.load();
}

function loaderOf<Props>(load: () => Promise<ComponentType<Props>>, appears = false) {
  const loader = new PartLoader(load);
  preloaded.add({ load: () => loader.load(), appears });
  return loader;
}

function useLoaded<Part>(loader: PartLoader<Part>, isWanted: boolean) {
  useEffect(() => {
    if (isWanted) void loader.load();
  }, [loader, isWanted]);
  return useSyncExternalStore(loader.listen, loader.state);
}

/**
 * A part with its own place: a panel, the content of a menu.
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
    if (state.kind === "failed") return <PartFailure onRetry={() => void retry(loader)} />;
    return <p className={styles["opening"]}>{t("offline.opening")}</p>;
  };
}

export interface DeferredProps {
  isWanted: boolean;
  children?: ReactNode;
}

/**
 * A part that can wait: it loads once it is wanted, or with all others in the background. Until
 * then its children replace it; they must have its size.
 */
export function deferredPart<Props extends object>(
  load: () => Promise<ComponentType<Props>>,
): ComponentType<Props & DeferredProps> {
  const loader = loaderOf(load, true);
  return function DeferredPart(props: Props & DeferredProps) {
    const { isWanted, children } = props;
    const state = useLoaded(loader, isWanted);
    if (state.kind === "ready") return <state.part {...props} />;
    if (state.kind === "failed" && isWanted) {
      return <PartFailure onRetry={() => void retry(loader)} />;
    }
    return children;
  };
}

interface DialogProps {
  isOpen: boolean;
  onClose: () => void;
}

/**
 * A part that is a dialog: it opens once its file has loaded; until then the screen does not
 * change.
 */
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
        <PartFailure onRetry={() => void retry(loader)} />
      </Dialog>
    );
  };
}

/**
 * Browsers cache a failed import for as long as the page is open, and a newer server does not have
 * this version's files: then only a reload helps. The page reloads only if the server responds, so
 * that a broken network does not cost the page. Leaving the page stores the project.
 */
async function retry(loader: PartLoader<unknown>): Promise<void> {
  await loader.load();
  if (loader.state().kind === "failed" && (await isReachable("/healthz"))) location.reload();
}

async function isReachable(address: string): Promise<boolean> {
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
