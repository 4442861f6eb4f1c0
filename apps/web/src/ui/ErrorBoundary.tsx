/** Displayed if rendering fails: the project is stored, with a button to reload. */
import { Component, type ReactNode } from "react";
import { useTranslation } from "react-i18next";
import { Button } from "./Button.tsx";
import styles from "./failure.module.css";

interface ErrorBoundaryProps {
  /** stores the documents before the user reloads */
  onError: () => void;
  children: ReactNode;
}

/** Renders its children until one of them fails. */
export class ErrorBoundary extends Component<ErrorBoundaryProps, { reason: string | null }> {
  override state: { reason: string | null } = { reason: null };

  static getDerivedStateFromError(error: unknown): { reason: string } {
    return { reason: error instanceof Error ? error.message : String(error) };
  }

  override componentDidCatch(): void {
    this.props.onError();
  }

  override render(): ReactNode {
    const { reason } = this.state;
    return reason === null ? this.props.children : <Failure reason={reason} />;
  }
}

function Failure({ reason }: { reason: string }) {
  const { t } = useTranslation();
  return (
    <main className={styles["failure"]} role="alert">
      <h1>{t("shell.failure.title")}</h1>
      <p>{t("shell.failure.text")}</p>
      <Button kind="primary" size="large" onClick={() => location.reload()}>
        {t("shell.failure.reload")}
      </Button>
      <p className={styles["reason"]}>{reason}</p>
    </main>
  );
}
