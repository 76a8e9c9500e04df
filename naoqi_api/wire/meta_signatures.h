#pragma once

/// The signatures of what an object says of itself, as qi has them: its MetaObject and the parts.
namespace nao::wire::meta {

inline constexpr char kParameter[] = "(ss)<MetaMethodParameter,name,description>";
inline constexpr char kMethod[] =
    "(Issss[(ss)<MetaMethodParameter,name,description>]s)"
    "<MetaMethod,uid,returnSignature,name,parametersSignature,description,parameters,"
    "returnDescription>";
inline constexpr char kSignal[] = "(Iss)<MetaSignal,uid,name,signature>";
inline constexpr char kProperty[] = "(Iss)<MetaProperty,uid,name,signature>";
inline constexpr char kMetaObject[] =
    "({I(Issss[(ss)<MetaMethodParameter,name,description>]s)"
    "<MetaMethod,uid,returnSignature,name,parametersSignature,description,parameters,"
    "returnDescription>}"
    "{I(Iss)<MetaSignal,uid,name,signature>}"
    "{I(Iss)<MetaProperty,uid,name,signature>}s)"
    "<MetaObject,methods,signals,properties,description>";

}  // namespace nao::wire::meta
