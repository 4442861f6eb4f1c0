/** Copies a text, and confirms it in words on the button and to screen readers. */
import { Check, Copy } from "lucide";
import { useEffect, useState } from "react";
import { Icon } from "./Icon.tsx";
import { Button, IconButton, type ButtonProps } from "./Button.tsx";
import { copyText, pageClipboard } from "./clipboard.ts";

/** Duration of the tick icon, in ms. */
const CONFIRM_MS = 2_000;

interface CopyButtonProps {
  /** a function creates the text when the button is pressed; null: it failed */
  text: string | (() => Promise<string | null>);
  label: string;
  /** announced after copying */
  done: string;
  /** button style with text beside the icon; without it, the button shows only the icon */
  kind?: NonNullable<ButtonProps["kind"]>;
  size?: NonNullable<ButtonProps["size"]>;
  /** called when the browser refuses: select the text for copying by hand */
  onRefused: () => void;
}

export function CopyButton({
  text,
  label,
  done,
  kind,
  size = "medium",
  onRefused,
}: CopyButtonProps) {
  const [isCopied, setCopied] = useState(false);
  useEffect(() => {
    if (!isCopied) return;
    const timer = setTimeout(() => setCopied(false), CONFIRM_MS);
    return () => clearTimeout(timer);
  }, [isCopied]);
  async function copy(): Promise<void> {
    const copied = typeof text === "string" ? text : await text();
    if (copied === null) return;
    if (await copyText(copied, pageClipboard())) setCopied(true);
    else onRefused();
  }
  const icon = isCopied ? <Icon of={Check} /> : <Icon of={Copy} />;
  return (
    <>
      {kind === undefined ? (
        <IconButton label={label} onClick={() => void copy()}>
          {icon}
        </IconButton>
      ) : (
        <Button kind={kind} size={size} icon={icon} onClick={() => void copy()}>
          {label}
        </Button>
      )}
      <output className="visually-hidden">{isCopied ? done : ""}</output>
    </>
  );
}
