import type { IconNode } from "lucide";
import { createElement, type SVGProps } from "react";

interface IconProps extends Omit<SVGProps<SVGSVGElement>, "of" | "children"> {
  of: IconNode;
  /** px */
  size?: number;
  /** whether the picture points along the text, so that it is mirrored in right-to-left languages */
  isDirectional?: boolean;
}

/** An icon of the Lucide set, hidden from screen readers: the control around it has the name. */
export function Icon({ of, size = 24, isDirectional = false, ...rest }: IconProps) {
  return (
    <svg
      xmlns="http://www.w3.org/2000/svg"
      width={size}
      height={size}
      viewBox="0 0 24 24"
      fill="none"
      stroke="currentColor"
      strokeWidth={2}
      strokeLinecap="round"
      strokeLinejoin="round"
      aria-hidden="true"
      data-directional={isDirectional || undefined}
      {...rest}
    >
      {of.map(([tag, attributes], at) => createElement(tag, { key: at, ...attributes }))}
    </svg>
  );
}
