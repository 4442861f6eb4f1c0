export {
  decodeLink,
  encodeLink,
  MAX_LINK_LENGTH,
  type DecodeResult,
  type EncodeRefusal,
  type EncodeResult,
  type LinkContent,
  type LinkRefusal,
} from "./link.ts";
