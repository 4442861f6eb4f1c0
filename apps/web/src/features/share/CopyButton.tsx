/** Copies a text and says so in words, on the button and to those who listen. */
import { Check, Copy } from "lucide-react";
import { useEffect, useState } from "react";
import { Button, IconButton, type ButtonProps } from "../../ui/Button.tsx";
import { copyText, pageClipboard } from "./clipboard.ts";

/** How long the tick stays, in ms. */
const CONFIRM_MS = 2_000;

interface CopyButtonProps {
  text: string;
  label: string;
  /** said once it is copied */
  done: string;
  /** with words beside the icon, in these clothes; an icon alone without */
  kind?: NonNullable<ButtonProps["kind"]>;
  size?: NonNullable<ButtonProps["size"]>;
  /** the browser refused: select the text for copying by hand */
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
    if (await copyText(text, pageClipboard())) setCopied(true);
    else onRefused();
  }
  const icon = isCopied ? <Check aria-hidden="true" /> : <Copy aria-hidden="true" />;
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
